#pragma once
// One network on hand-made voxels under one sampler: what most tests of the chemistry start from.
#include <gtest/gtest.h>

#include <memory>

#include "lattice.hpp"
#include "rdme/sampler.hpp"
#include "statistics.hpp"

namespace shmoo::rdme {

struct Trial {
  Network network;
  Voxels voxels;
  State state;
  std::unique_ptr<Sampler> sampler;
  base::RandomKey key{1, 0};
  double t = 0;
  std::uint64_t step = 0;

  Trial(scene::Sampler method, const scene::Scene& scene, Voxels on)
      : network(scene),
        voxels(std::move(on)),
        state(empty_state(network, voxels.size())),
        sampler(make_sampler(method, network)) {}

  Trial(const Trial&) = delete;

  // To be called once the numbers at the start stand in `state`.
  void begin() {
    open_ledger(state, network);
    sampler->bind(voxels, state);
  }

  void run(double until, double dt, Process process = Process::both) {
    while (t < until * (1 - 1e-12)) {
      const double now = std::min(dt, until - t);
      sampler->advance(t, now, process, key, step++);
      t += now;
    }
    EXPECT_EQ(imbalance(state, network), "");
    for (std::int64_t n : state.count) ASSERT_GE(n, 0);
  }

  Sample sample(int species) const {
    Sample sample;
    for (std::size_t i = species; i < state.count.size(); i += state.species)
      sample.add(static_cast<double>(state.count[i]));
    return sample;
  }
};

inline void expect_mean(const Sample& sample, double mean) {
  EXPECT_NEAR(sample.mean(), mean, errors_allowed * sample.standard_error() + 1e-12);
}
inline void expect_variance(const Sample& sample, double variance) {
  EXPECT_NEAR(sample.variance(), variance, errors_allowed * sample.variance_error() + 1e-12);
}

inline const auto every_method = testing::Values(scene::Sampler::direct, scene::Sampler::composition_rejection,
                                                 scene::Sampler::split, scene::Sampler::tau_leaping);

inline std::string method_name(const testing::TestParamInfo<scene::Sampler>& info) {
  const char* const names[] = {"direct", "composition_rejection", "split", "tau_leaping"};
  return names[static_cast<int>(info.param)];
}

}  // namespace shmoo::rdme
