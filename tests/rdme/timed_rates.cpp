// Rates that contain t, by every method: the laws of births and deaths at k(t) are known.
#include "rdme/deterministic.hpp"
#include "rdme/time/steps_of.hpp"
#include "rdme/time/timed_rate.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr double one_in_a_million = 1e-6;  // false alarms of each check

// The direct method looks at all voxels in each event.
std::uint32_t voxels(scene::Sampler method) { return method == scene::Sampler::direct ? 400 : 2000; }

class TimedRates : public testing::TestWithParam<scene::Sampler> {};

// Numbers of many voxels after births at k(t) from 0 to 10 s, in steps of `step`, against Poisson(`mean`).
double chance_of_births(scene::Sampler method, const std::string& rate, double mean, double step) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X");
  add_reaction(scene, "birth", {}, {{x, 1}}, 0, rate);
  Trial trial(method, scene, lattice({voxels(method), 1, 1}, false, 1.0, 1));
  trial.voxels.graph_of_species = {-1};
  trial.begin();
  trial.run(10.0, step);
  return chi_square(trial.sample(x), poisson_law(mean, int(mean + 10 * std::sqrt(mean) + 10)));
}

TEST_P(TimedRates, BirthsAtASineArePoisson) {
  const double mean = 8.0 * 10.0 + 6.0 / 2.5 * (1.0 - std::cos(25.0));
  EXPECT_GT(chance_of_births(GetParam(), "8 + 6*sin(2.5*t)", mean, 10.0), one_in_a_million);
  EXPECT_GT(chance_of_births(GetParam(), "8 + 6*sin(2.5*t)", mean, 0.7), one_in_a_million);
}

TEST_P(TimedRates, BirthsAcrossAJumpArePoisson) {
  EXPECT_GT(chance_of_births(GetParam(), "t > 4.3 ? 2 : 0.1", 0.43 + 11.4, 10.0), one_in_a_million);
}

// A pulse of a hundred-thousandth of the step, and a train of pulses.
TEST_P(TimedRates, BirthsInPulsesArePoisson) {
  EXPECT_GT(chance_of_births(GetParam(), "t > 7 && t < 7.0001 ? 90000 : 0", 9.0, 10.0), one_in_a_million);
  const double duty = std::acos(0.9) / 3.14159265358979323846;
  EXPECT_GT(chance_of_births(GetParam(), "cos(2*_pi*t) > 0.9 ? 10 : 0", 10 * 10 * duty, 10.0), one_in_a_million);
  EXPECT_GT(chance_of_births(GetParam(), "1 + sign(sin(2*_pi*t))", 10.0, 10.0), one_in_a_million);
}

// Where a jump stands depends on the place: a front that passes voxel after voxel.
TEST_P(TimedRates, BirthsBehindAFrontArePoisson) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X");
  add_reaction(scene, "birth", {}, {{x, 1}}, 0, "t > x/400 && t < x/400 + 0.001 ? 6000 : 0");
  Trial trial(GetParam(), scene, lattice({voxels(GetParam()), 1, 1}, false, 1.0, 1));
  trial.voxels.graph_of_species = {-1};
  trial.begin();
  trial.run(10.0, 5.0);
  EXPECT_GT(chi_square(trial.sample(x), poisson_law(6.0, 40)), one_in_a_million);
}

TEST_P(TimedRates, DeathsAreBinomial) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X"), y = add_species(scene, "Y");
  add_reaction(scene, "death", {{x, 1}}, {{y, 1}}, 0, "X*(t < 0.5 ? 2*t : 0.3 + 0.2*cos(9*t))");
  Trial trial(GetParam(), scene, lattice({voxels(GetParam()), 1, 1}, false, 1.0, 2));
  trial.voxels.graph_of_species = {-1, -1};
  fill(trial.state, x, 20);
  trial.begin();
  trial.run(2.0, 2.0);
  const double left = std::exp(-(0.25 + 0.45 + 0.2 / 9 * (std::sin(18.0) - std::sin(4.5))));
  std::vector<double> law;
  for (int n = 0; n <= 20; ++n)
    law.push_back(std::exp(std::lgamma(21.0) - std::lgamma(n + 1.0) - std::lgamma(21.0 - n)) * std::pow(left, n) *
                  std::pow(1 - left, 20 - n));
  EXPECT_GT(chi_square(trial.sample(x), law), one_in_a_million);
}

// Everything else goes on as if nothing depended on time: jumps between two voxels while births end.
TEST_P(TimedRates, DiffusionIsUntouched) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X", 1.0), y = add_species(scene, "Y");
  add_reaction(scene, "birth", {}, {{y, 1}}, 0, "t < 0.3 ? 5 : 0");
  Sample left;
  for (std::uint32_t k = 0; k < 400; ++k) {
    Trial trial(GetParam(), scene, lattice({2, 1, 1}, false, 1.0, 2));
    trial.voxels.graph_of_species = {0, -1};
    trial.key = {4, k};
    trial.state.count[0] = 20;
    trial.begin();
    trial.run(0.5, 0.25);
    left.add(double(trial.state.count[0]));
    EXPECT_EQ(total_count(trial.state, x), 20);
  }
  expect_mean(left, 20 * 0.5 * (1 + std::exp(-1.0)));
}

TEST_P(TimedRates, RefuseWhatIsInvalidInMidRun) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X");
  add_reaction(scene, "birth", {}, {{x, 1}}, 0, "2 - t");
  Trial trial(GetParam(), scene, lattice({3, 1, 1}, false, 1.0, 1));
  trial.voxels.graph_of_species = {-1};
  trial.begin();
  trial.run(1.0, 1.0);
  try {
    trial.run(3.0, 2.0);
    FAIL() << "a negative rate was taken";
  } catch (const base::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("reaction birth"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("voxel 0"), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Method, TimedRates, every_method, method_name);

// Integrated rates: a pulse far shorter than what the integrator would step over counts in full.
TEST(TimedRates, IntegratedPulsesAreSeen) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X", 0.0, scene::SpeciesMethod::deterministic);
  add_reaction(scene, "birth", {}, {{x, 1}}, 0, "t > 7 && t < 7.0001 ? 90000 : (t > 9 ? 3 : 2)");
  const Network network(scene);
  const Voxels voxels = lattice({1, 1, 1}, false, 1.0, 1);
  State state = empty_state(network, 1);
  open_ledger(state, network);
  DeterministicSolver solver(network, 1e-8);
  solver.bind(voxels, state);
  EXPECT_EQ(solver.advance(0.0, 5.0, Process::both), 5.0);
  EXPECT_EQ(solver.advance(5.0, 4.0, Process::both), 9.0);
  solver.advance(9.0, 1.0, Process::both);
  EXPECT_NEAR(state.amount[x], 2 * (9 - 0.0001) + 9 + 3, 1e-6);
  EXPECT_EQ(imbalance(state, network), "");
}

TEST(StepsOf, FindsComparisonsAndRoundings) {
  const auto steps = steps_of("k*(t >= a+1 && f(t, 2) < b ? 1 : sign(t-3))");
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].level, "(t )>=( a+1 )");
  EXPECT_EQ(steps[1].distance, "( f(t, 2) )-( b )");
  EXPECT_EQ(steps[2].level, "sign(t-3)");
}

// Neither a hidden pulse nor a step may lie above the bound.
TEST(TimedRate, BoundsHoldAndStepsAreFoundToTheLastBit) {
  TimedRate rate("t > 3 ? (t < 3.000001 ? 7 : 1) : 2", {});
  std::vector<double> moments;
  rate.common_steps(0.0, 10.0, moments);
  std::sort(moments.begin(), moments.end());
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  ASSERT_EQ(moments.size(), 2U);
  EXPECT_EQ(moments[0], std::nextafter(3.0, 4.0));
  EXPECT_EQ(moments[1], 3.000001);
  TimedRate smooth("5 + 4*sin(t)", {});
  EXPECT_GE(smooth.bound(0.0, 3.0), 9.0);
  EXPECT_EQ(TimedRate("1 - t", {}).bound(0.0, 2.0) < 0, true);
}

}  // namespace
}  // namespace shmoo::rdme
