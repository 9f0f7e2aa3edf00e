// A quasi-static run gives the same bits for any number of threads, and the same file whether it was stopped or not.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstdlib>

#include "../run/scratch.hpp"
#include "memory_sink.hpp"
#include "run/ensemble.hpp"

namespace {

using namespace shmoo;

// Three layers and 40 columns, few enzymes, 60 s.
scene::Scene few_enzymes() {
  return scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/yeast-projection/case-1-stochastic.toml",
                           {{"domain.spacing", "\"0.8 um\""},
                            {"mechanics.columns", "40"},
                            {"run.until", "\"60 s\""},
                            {"run.record_every", "\"30 s\""}});
}

TEST(QuasiStaticBits, ForOneTwoAndFiveThreads) {
  const int before = omp_get_max_threads();
  std::vector<std::map<std::string, std::map<std::size_t, std::vector<double>>>> fields, numbers;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    const test::Laboratory lab(few_enzymes());
    if (threads == 2) lab.realise(7);  // what ran before must not matter
    const auto told = lab.realise(3);
    fields.push_back(told.fields());
    numbers.push_back(told.observables());
  }
  omp_set_num_threads(before);
  for (std::size_t k = 1; k < fields.size(); ++k) {
    EXPECT_EQ(fields[k], fields[0]);
    EXPECT_EQ(numbers[k], numbers[0]);
  }
  EXPECT_FALSE(numbers[0].empty());
}

void ensemble(const std::filesystem::path& out, std::uint32_t n, int threads, bool resume) {
  const auto experiment = coupling::make_experiment(few_enzymes());
  run::run_ensemble(*experiment, {.output = out, .realisations = n, .threads = threads, .resume = resume});
}

TEST(QuasiStaticBits, AResumedFileIsTheWholeOne) {
  const run::Scratch scratch;
  const auto whole = scratch / "whole.h5", parts = scratch / "parts.h5";
  ensemble(whole, 3, 2, false);
  ensemble(parts, 1, 1, false);
  ensemble(parts, 3, 2, true);
  const auto command =
      fmt::format("h5diff --exclude-path=/provenance '{}' '{}' >/dev/null", whole.string(), parts.string());
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
