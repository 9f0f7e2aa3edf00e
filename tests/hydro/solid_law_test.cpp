// What an elastic material point and the reference neighbourhood owe to mechanics, whatever integrates them in time.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "base/error.hpp"
#include "hydro/solid/elastic_law.hpp"
#include "hydro/solid/reference_rows.hpp"

namespace shmoo::hydro::testing {
namespace {

using scene::ElasticLaw;
const Moduli material = moduli(3.58e5, 0.3975);

// A fixed, sizeable deformation without any symmetry.
template <int D>
Deformation<D> bent() {
  Deformation<D> at;
  for (int a = 0; a < D; ++a) {
    for (int b = 0; b < D; ++b) at.F(a, b) += 0.1 * std::sin(1.0 + 3.0 * a + 5.0 * b);
  }
  if (D == 2) at.hoop = 1.17;
  return at;
}

template <int D>
Deformation<D> moved(Deformation<D> at, int entry, double by) {
  if (entry < D * D)
    at.F(entry % D, entry / D) += by;
  else
    at.hoop += by;
  return at;
}

template <int D>
Strains<D> flat(const Stress<D>& stress) {
  Strains<D> all;
  all.template head<D * D>() = Eigen::Map<const Eigen::Matrix<double, D * D, 1>>(stress.P.data());
  if constexpr (D == 2) all[4] = stress.hoop;
  return all;
}

template <int D>
void check_derivatives(ElasticLaw law) {
  const auto at = bent<D>();
  const ElasticPoint<D> point(law, material, at);
  const double h = 1e-5;
  Strains<D> slope;
  Tangent<D> tangent;
  for (int e = 0; e < strains<D>; ++e) {
    const ElasticPoint<D> up(law, material, moved(at, e, h)), down(law, material, moved(at, e, -h));
    slope[e] = (up.energy() - down.energy()) / (2.0 * h);
    tangent.col(e) = (flat(up.stress()) - flat(down.stress())) / (2.0 * h);
  }
  EXPECT_LT((flat(point.stress()) - slope).norm(), 1e-7 * slope.norm());
  EXPECT_LT((point.tangent() - tangent).norm(), 1e-7 * tangent.norm());
}

class Law : public ::testing::TestWithParam<ElasticLaw> {};
INSTANTIATE_TEST_SUITE_P(All, Law, ::testing::Values(ElasticLaw::neo_hookean, ElasticLaw::saint_venant_kirchhoff));

TEST_P(Law, StressAndTangentAreDerivativesOfTheEnergy) {
  check_derivatives<2>(GetParam());
  check_derivatives<3>(GetParam());
}

// Small strains: sigma = 2 G dev(e) + K tr(e), in plane strain with its stress across the plane.
TEST_P(Law, IsHookesForSmallStrains) {
  Deformation<2> at;
  const double small = 1e-7;
  at.F << 1.0 + small, 0.5 * small, 0.3 * small, 1.0 - 0.2 * small;
  const auto stress = cauchy(ElasticPoint<2>(GetParam(), material, at).stress(), at);
  const double trace = 0.8 * small, lame = (material.bulk - 2.0 / 3.0 * material.shear) * trace, G = material.shear;
  EXPECT_NEAR(stress.P(0, 0), 2.0 * G * small + lame, 1e-5 * G * small);
  EXPECT_NEAR(stress.P(1, 1), -0.4 * G * small + lame, 1e-5 * G * small);
  EXPECT_NEAR(stress.P(0, 1), 0.8 * G * small, 1e-5 * G * small);
  EXPECT_NEAR(stress.hoop, lame, 1e-5 * G * small);
}

TEST_P(Law, TurningAllTheWayLeavesNoStress) {
  for (int degrees = 0; degrees <= 360; degrees += 15) {
    const double angle = degrees * std::numbers::pi / 180.0;
    Deformation<3> at;
    at.F = Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    EXPECT_LT(ElasticPoint<3>(GetParam(), material, at).stress().P.norm(), 1e-10 * material.shear) << degrees;
  }
}

TEST(Law, RefusesAPointTurnedInsideOut) {
  Deformation<2> at;
  at.F(0, 0) = -1.0;
  EXPECT_THROW(ElasticPoint<2>(ElasticLaw::neo_hookean, material, at), base::RunError);
}

TEST(Law, SoftensNoFurtherThanItsLeast) {
  const scene::Softening softening{0, 0.5, 0.01};
  EXPECT_DOUBLE_EQ(softened(10.0, softening, 1.0), 5.0);
  EXPECT_DOUBLE_EQ(softened(10.0, softening, 100.0), 0.1);
  EXPECT_DOUBLE_EQ(softened(10.0, softening, -1.0), 10.0);
}

// A block of particles off their lattice.
template <int D>
std::vector<base::Vec<D>> jittered(int side, double jitter) {
  std::vector<base::Vec<D>> X;
  const int count = D == 2 ? side * side : side * side * side;
  for (int k = 0; k < count; ++k) {
    const int place[] = {k % side, k / side % side, k / side / side};
    base::Vec<D> x;
    for (int a = 0; a < D; ++a) x[a] = (place[a] + 0.5 + jitter * std::sin(7.3 * k + 2.1 * a)) / side;
    X.push_back(x);
  }
  return X;
}

template <int D>
void check_patch(int side) {
  const auto X = jittered<D>(side, 0.2);
  const std::vector<double> volume(X.size(), std::pow(1.0 / side, D));
  const auto rows = make_reference_rows<D>(X, volume, {}, base::Box<D>{}, 2.6 / side);
  const auto F = bent<D>().F;
  auto x = X;
  for (auto& one : x) one = F * one + base::Vec<D>::Constant(0.7);
  for (std::size_t i = 0; i < X.size(); ++i) EXPECT_LT((rows.gradient_of(x, i) - F).norm(), 1e-10) << i;
}

TEST(ReferenceRows, LinearDisplacementIsExactOnAnyArrangement) {
  check_patch<2>(12);
  check_patch<3>(6);
}

TEST(ReferenceRows, BodiesDoNotFeelEachOther) {
  const auto X = jittered<2>(12, 0.2);
  std::vector<std::uint16_t> body(X.size());
  for (std::size_t i = 0; i < X.size(); ++i) body[i] = X[i][0] > 0.5 ? 1 : 0;
  const auto rows =
      make_reference_rows<2>(X, std::vector<double>(X.size(), 1.0 / 144.0), body, base::Box<2>{}, 2.6 / 12.0);
  for (std::size_t i = 0; i < X.size(); ++i) {
    for (auto p = rows.first[i]; p < rows.first[i + 1]; ++p) EXPECT_EQ(body[i], body[rows.neighbour[p]]);
  }
}

TEST(ReferenceRows, RefusesAWallOneParticleThick) {
  std::vector<base::Vec<2>> X;
  for (int k = 0; k < 10; ++k) X.emplace_back(0.05 + 0.1 * k, 0.5);
  EXPECT_THROW(make_reference_rows<2>(X, std::vector<double>(10, 0.01), {}, base::Box<2>{}, 0.26), base::InputError);
}

}  // namespace
}  // namespace shmoo::hydro::testing
