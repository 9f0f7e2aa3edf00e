// The same bits for any number of threads; the scenes are large enough that every loop uses them.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// Positions, velocities and densities by id after some steps.
template <int D>
std::vector<double> run(const scene::Scene& scene, int threads) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  auto fluid = make_fluid<D>(scene);
  for (int k = 0; k < 5; ++k) fluid.step();
  omp_set_num_threads(before);
  constexpr std::size_t width = 2 * D + 1;
  std::vector<double> values(width * fluid.particles().size());
  for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
    double* at = values.data() + width * fluid.particles().id[i];
    for (int a = 0; a < D; ++a) {
      *at++ = fluid.particles().position[i][a];
      *at++ = fluid.state().velocity[i][a];
    }
    *at = fluid.state().density[i];
  }
  return values;
}

template <int D>
void same_bits(const scene::Scene& scene) {
  const auto one = run<D>(scene, 1);
  for (const int threads : {2, 5}) {
    const auto more = run<D>(scene, threads);
    ASSERT_EQ(more.size(), one.size());
    EXPECT_EQ(std::memcmp(more.data(), one.data(), one.size() * sizeof(double)), 0) << threads << " threads";
  }
}

}  // namespace

TEST(Threads, ACavityHasTheSameBits) { same_bits<2>(cavity_scene(140, 100)); }

TEST(Threads, NoiseHasTheSameBits) {
  auto scene = box_scene(3, 1.0, 1.0 / 15, 0.1);
  scene.effects.thermal_noise = true;
  scene.flow.thermal_energy = 1e-4;
  same_bits<3>(scene);
}

}  // namespace shmoo::hydro::testing
