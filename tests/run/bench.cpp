// shmoo bench on the command line, and its yardstick.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "run/bench/lattice_problem.hpp"
#include "run/bench/next_subvolume.hpp"
#include "run/bench/problem.hpp"
#include "said.hpp"

namespace {

using namespace shmoo;

test::Said bench(std::vector<const char*> words) {
  words.insert(words.begin(), "bench");
  return test::say(std::move(words));
}

TEST(Bench, MeasuresAWorkloadAndChecksItsLaw) {
  const auto said = bench({"D3-10", "--method", "exact-composition-rejection", "--seconds", "0.05", "--json"});
  EXPECT_EQ(said.code, run::exit_done) << said.out << said.err;
  const auto line = nlohmann::json::parse(said.out);
  EXPECT_EQ(line.at("workload"), "D3-10");
  EXPECT_EQ(line.at("unit"), "events per CPU second");
  EXPECT_GT(line.at("rate").get<double>(), 0.0);
  EXPECT_GE(line.at("cpu_seconds").get<double>(), 0.05);
  EXPECT_GT(line.at("bytes_per_voxel").get<double>(), 0.0);
  EXPECT_TRUE(line.at("right").get<bool>());
}

TEST(Bench, EveryMethodIsRightOnSmallWorkloads) {
  const auto said = bench({"D3-10", "RD-10", "ring-10", "dimer", "--seconds", "0.05", "--json"});
  EXPECT_EQ(said.code, run::exit_done) << said.out << said.err;
  std::istringstream lines(said.out);
  std::set<std::string> methods;
  for (std::string line; std::getline(lines, line);) {
    const auto one = nlohmann::json::parse(line);
    EXPECT_TRUE(one.at("right").get<bool>()) << line;
    methods.insert(one.at("method").get<std::string>());
  }
  EXPECT_GE(methods.size(), 6U);
}

TEST(Bench, RefusesWhatItDoesNotKnow) {
  auto said = bench({"D4-11"});
  EXPECT_EQ(said.code, run::exit_input);
  EXPECT_NE(said.err.find("there is no workload 'D4-11'; there are: CAVITY-100, D-sph, D3-10"), std::string::npos) << said.err;
  said = bench({"--method", "guess"});
  EXPECT_NE(said.err.find("there is no method 'guess'"), std::string::npos);
  said = bench({"D3-10", "--seconds", "-1"});
  EXPECT_NE(said.err.find("--seconds got '-1'"), std::string::npos);
}

// The heap samples the same law as every other method: C in equilibrium with A and B, time and again.
TEST(Bench, TheYardstickIsRight) {
  const rdme::Network network(run::bench::binding_scene(10.0));
  const auto voxels = run::bench::lattice({4, 4, 4}, 3);
  auto state = rdme::empty_state(network, voxels.size());
  run::bench::fill_poisson(state, 10.0);
  const auto a_and_c = rdme::total_count(state, 0) + rdme::total_count(state, 2);
  run::bench::NextSubvolume heap(network, voxels, state);
  const auto right = run::bench::binding_problem(4);
  double mean = 0.0;
  constexpr int looks = 400;
  for (int k = 0; k < looks; ++k) {
    heap.events(20000);  // several events a molecule between looks
    mean += right.deviations(run::bench::counts_of(state)) / looks;
  }
  EXPECT_EQ(rdme::total_count(state, 0) + rdme::total_count(state, 2), a_and_c);
  // 180 of each per voxel and second at these means.
  EXPECT_NEAR(double(state.jump_events) / double(state.reaction_events), 1.0, 0.05);
  EXPECT_NEAR(mean, 0.0, 5.0 / std::sqrt(double(looks)));
}

}  // namespace
