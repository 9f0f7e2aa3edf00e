#include "hydro/steadiness.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace shmoo::hydro::testing {

TEST(Steadiness, IsInfiniteBeforeThereIsAPast) {
  auto fluid = make_fluid<2>(taylor_green_scene(16));
  Steadiness<2> steadiness(fluid);
  EXPECT_EQ(steadiness.measure(fluid), std::numeric_limits<double>::infinity());
  EXPECT_EQ(steadiness.measure(fluid), std::numeric_limits<double>::infinity());
}

// Particles that travel through a field that stands still see no change; Taylor-Green vortices fade by exp(b t).
TEST(Steadiness, MeasuresTheDecayOfVortices) {
  auto fluid = make_fluid<2>(taylor_green_scene(40));
  Steadiness<2> steadiness(fluid);
  fluid.advance(0.1);
  steadiness.measure(fluid);
  fluid.advance(0.4);
  const double rate = 8 * sph::pi * sph::pi * 0.01;
  EXPECT_NEAR(steadiness.measure(fluid), (std::exp(rate * 0.3) - 1.0) / 0.3, 0.15 * rate);
}

TEST(Steadiness, FallsAsAChannelSettles) {
  auto fluid = make_fluid<2>(poiseuille_scene(12));
  Steadiness<2> steadiness(fluid);
  fluid.advance(0.5);
  steadiness.measure(fluid);
  fluid.advance(1.0);
  const double early = steadiness.measure(fluid);
  fluid.advance(10.0);
  steadiness.measure(fluid);
  fluid.advance(11.0);
  EXPECT_GT(early, 0.3);
  EXPECT_LT(steadiness.measure(fluid), 5e-3);
}

}  // namespace shmoo::hydro::testing
