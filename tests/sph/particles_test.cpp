#include "sph/particles.hpp"

#include <gtest/gtest.h>

namespace {

using namespace shmoo;

TEST(Particles, AColumnExistsOnlyAfterItWasAskedFor) {
  sph::Particles<2> particles;
  particles.resize(10);
  const auto before = particles.bytes();
  EXPECT_EQ(particles.find("velocity"), nullptr);
  auto& velocity = particles.require<base::Vec<2>>("velocity", "m/s");
  EXPECT_EQ(particles.bytes(), before + 10 * sizeof(base::Vec<2>));
  EXPECT_EQ(velocity[3].norm(), 0.0);
  EXPECT_EQ(&particles.require<base::Vec<2>>("velocity", "m/s"), &velocity);
  EXPECT_THROW(particles.require<double>("velocity", "m/s"), std::logic_error);
}

TEST(Particles, APermutationMovesEveryColumn) {
  sph::Particles<1> particles;
  particles.resize(3);
  auto& mass = particles.require<double>("mass", "kg");
  for (std::uint32_t i = 0; i < 3; ++i) {
    particles.id[i] = i;
    mass[i] = 10.0 * i;
  }
  const std::vector<std::uint32_t> order{2, 0, 1};
  particles.permute(order);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mass[i], 10.0 * particles.id[i]);
  EXPECT_EQ(particles.id[0], 2u);
}

}  // namespace
