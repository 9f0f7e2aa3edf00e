// Laws of the kernels: unit integral in every dimension, F = -W'/r, nothing beyond the reach.
#include "sph/kernel.hpp"

#include <gtest/gtest.h>

namespace {

using namespace shmoo;

double sphere_surface(int dimension, double r) {
  return dimension == 1 ? 2.0 : dimension == 2 ? 2.0 * sph::pi * r : 4.0 * sph::pi * r * r;
}

template <int D>
void check_kernel(scene::Kernel kind) {
  const double reach = 2.7;
  std::visit(
      [&](const auto& kernel) {
        const int n = 20000;
        double integral = 0.0;
        for (int k = 0; k < n; ++k) {
          const double r = reach * (k + 0.5) / n;
          integral += kernel.W(r) * sphere_surface(D, r) * reach / n;
          const double step = 1e-5;
          const double slope = (kernel.W(r + step) - kernel.W(r - step)) / (2.0 * step);
          EXPECT_NEAR(kernel.F(r) * r, -slope, 1e-8);
          EXPECT_GE(kernel.F(r), 0.0);
        }
        EXPECT_NEAR(integral, 1.0, D == 2 ? 3e-5 : 1e-6);
        EXPECT_EQ(kernel.W(reach * 1.0001), 0.0);
        EXPECT_EQ(kernel.F(reach * 1.0001), 0.0);
      },
      sph::make_kernel<D>(kind, reach));
}

class Kernels : public testing::TestWithParam<scene::Kernel> {};

TEST_P(Kernels, IntegrateToOneAndAgreeWithTheirSlope) {
  check_kernel<1>(GetParam());
  check_kernel<2>(GetParam());
  check_kernel<3>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, Kernels,
                         testing::Values(scene::Kernel::lucy, scene::Kernel::cubic_spline,
                                         scene::Kernel::quintic_spline, scene::Kernel::wendland_c2));

}  // namespace
