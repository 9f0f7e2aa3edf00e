// Exact events by bounds that all voxels share: the same laws as everywhere, also while bounds rise, where voxels cease
// to be alike and where they become so.
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr auto exact = scene::Sampler::composition_rejection;

// From one voxel, by groups, until all are alike and bounds are shared; then at equilibrium.
TEST(SharedBounds, FollowAPulseThatSpreads) {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0);
  Trial trial(exact, scene, lattice({20, 1, 1}, true, 1.0, 1));
  trial.state.count[7] = 1000;
  trial.begin();
  Sample one, beyond;
  trial.run(100.0, 10.0);
  for (int k = 0; k < 300; ++k) {
    trial.run(trial.t + 40.0, 10.0);
    one.add(double(trial.state.count[2]));
    beyond.add(double(trial.state.count[17]));
  }
  expect_mean(one, 50.0);
  expect_variance(one, 1000.0 / 20 * 19 / 20);
  expect_mean(beyond, 50.0);
}

// Births raise the bounds time and again: Yule's process, geometric in number (mean e^t, variance e^t (e^t - 1)), in
// each of many voxels.
TEST(SharedBounds, RiseWithBirths) {
  scene::Scene scene = water();
  add_species(scene, "A", 0.0);
  add_reaction(scene, "birth", {{0, 1}}, {{0, 2}}, 1.0);
  Trial trial(exact, scene, lattice({4000, 1, 1}, true, 1.0, 1));
  fill(trial.state, 0, 1);
  trial.begin();
  trial.run(2.0, 0.7);
  const Sample sample = trial.sample(0);
  const double growth = std::exp(2.0);
  expect_mean(sample, growth);
  expect_variance(sample, growth * (growth - 1.0));
  std::vector<double> law{0.0};
  for (int n = 1; n < 60; ++n) law.push_back(1.0 / growth * std::pow(1.0 - 1.0 / growth, n - 1));
  EXPECT_GT(chi_square(sample, law), false_alarm);
}

// In voxels of unequal volumes, one of a second material where nothing reacts.
TEST(SharedBounds, TakeVolumesAndMaterialsAsTheyAre) {
  scene::Scene scene = water();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "oil";
  add_species(scene, "A", 0.0);
  scene.species[0].homes = {0, 1};
  add_reaction(scene, "entry", {}, {{0, 1}}, 5.0);
  add_reaction(scene, "pair", {{0, 2}}, {}, 0.5);
  scene.reactions[0].materials = scene.reactions[1].materials = {0};
  const auto mean_in = [&](double volume) {  // by every other voxel's volume
    Trial trial(exact, scene, lattice({3000, 1, 1}, true, 1.0, 1));
    for (std::size_t i = 0; i < 3000; ++i) {
      trial.voxels.volume[i] = i % 2 == 0 ? volume : 3.0;
      trial.voxels.material[i] = i % 3 == 0 ? 1 : 0;
    }
    trial.begin();
    trial.run(1.5, 0.5);
    Sample sample;
    for (std::size_t i = 0; i < 3000; i += 2) {
      if (i % 3 == 0)
        EXPECT_EQ(trial.state.count[i], 0);
      else
        sample.add(double(trial.state.count[i]));
    }
    return sample;
  };
  // The same by the direct method, voxel by voxel alone.
  Trial plain(scene::Sampler::direct, scene, lattice({1500, 1, 1}, true, 1.0, 1));
  plain.voxels.volume.assign(1500, 0.7);
  plain.begin();
  plain.run(1.5, 1.5);
  const Sample wanted = plain.sample(0), found = mean_in(0.7);
  EXPECT_NEAR(found.mean(), wanted.mean(),
              errors_allowed * std::hypot(found.standard_error(), wanted.standard_error()));
  EXPECT_NEAR(found.variance(), wanted.variance(),
              errors_allowed * std::hypot(found.variance_error(), wanted.variance_error()));
}

}  // namespace
}  // namespace shmoo::rdme
