// Amounts at the start: exact means, exact totals, later entries over earlier ones, and what is refused.
#include "rdme/initial.hpp"

#include "base/error.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

scene::ShapePointer first_half() {
  return std::make_shared<scene::Shape>(scene::Shape{scene::BoxShape{{0, 0, 0}, {5, 1, 1}}});
}

scene::Scene two_species() {
  scene::Scene scene = water();
  scene.parameters["c0"] = 1.5;
  add_species(scene, "A");
  add_species(scene, "D", 0, scene::SpeciesMethod::deterministic);
  return scene;
}

scene::Initial concentration(int species, double value, const std::string& expression = {}) {
  scene::Initial initial;
  initial.species = species;
  initial.concentration = {value, expression};
  return initial;
}

scene::Initial count(int species, double value) {
  scene::Initial initial;
  initial.species = species;
  initial.count = value;
  return initial;
}

Voxels row(std::uint32_t n) {
  Voxels voxels = lattice({n, 1, 1}, false, 2.0, 2);
  voxels.volume[0] = 6.0;
  return voxels;
}

TEST(InitialState, RoundsConcentrationsWithTheExactMean) {
  scene::Scene scene = two_species();
  scene.initials = {concentration(0, 0, "c0 + 0.1*x"), concentration(1, 1.3)};
  const Network network(scene);
  const Voxels voxels = row(10);
  Sample third;
  for (std::uint32_t k = 0; k < 3000; ++k) {
    const State state = initial_state(scene, network, voxels, {5, k});
    EXPECT_EQ(imbalance(state, network), "");
    third.add(static_cast<double>(state.count[2 * 3]));
    EXPECT_EQ(state.amount[1], 1.3 * 6.0);
    EXPECT_EQ(state.amount[3], 1.3 * 2.0);
  }
  const double mean = 2.0 * (1.5 + 0.1 * 3.5);  // 3.7: three or four
  expect_mean(third, mean);
  expect_variance(third, 0.7 * 0.3);
}

TEST(InitialState, SpreadsACountByVolumeWithTheExactTotal) {
  scene::Scene scene = two_species();
  scene.initials = {count(0, 48), count(1, 12.5)};
  const Network network(scene);
  const Voxels voxels = row(10);  // volumes 6 and nine times 2
  Sample first, last;
  for (std::uint32_t k = 0; k < 3000; ++k) {
    const State state = initial_state(scene, network, voxels, {5, k});
    ASSERT_EQ(total_count(state, 0), 48);
    first.add(static_cast<double>(state.count[0]));
    last.add(static_cast<double>(state.count[2 * 9]));
    EXPECT_NEAR(total_amount(state, 1), 12.5, 1e-13);
  }
  expect_mean(first, 12);
  expect_variance(first, 48 * 0.25 * 0.75);
  expect_mean(last, 4);
  expect_variance(last, 48.0 / 12 * 11 / 12);
}

TEST(InitialState, LaterEntriesHoldWhereTheyOverlap) {
  scene::Scene scene = two_species();
  scene::Initial later = concentration(0, 3.0);
  later.shape = first_half();
  scene.initials = {count(0, 100), later};
  const State state = initial_state(scene, Network(scene), row(10), {1, 0});
  EXPECT_EQ(state.count[0], 18);
  EXPECT_EQ(state.count[2 * 4], 6);
  EXPECT_EQ(total_count(state, 0), 18 + 4 * 6 + 100);
}

TEST(InitialState, RefusesWhatCannotBe) {
  scene::Initial nowhere = concentration(0, 1.0);
  nowhere.shape = std::make_shared<scene::Shape>(scene::Shape{scene::BallShape{{50, 0, 0}, 1.0}});
  scene::Initial above = concentration(0, 1.0);
  for (const std::vector<scene::Initial>& initials :
       std::vector<std::vector<scene::Initial>>{{nowhere},
                                                {count(0, 2.5)},
                                                {count(0, -1)},
                                                {concentration(0, -1)},
                                                {concentration(0, 0, "1 - x")},
                                                {concentration(0, 0, "sqrt(-x)")},
                                                {concentration(0, 0, "unknown")},
                                                {concentration(0, 1e300)},
                                                {count(0, 5), above}}) {
    scene::Scene scene = two_species();
    scene.initials = initials;
    EXPECT_THROW(initial_state(scene, Network(scene), row(10), {1, 0}), base::InputError);
  }
}

}  // namespace
}  // namespace shmoo::rdme
