// Diffusion in a shell whose half plane is all that is simulated.
#include "rdme/tensor_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace shmoo::rdme::testing {
namespace {

using std::numbers::pi;

struct Wall {
  std::vector<base::Vec<2>> position;
  std::vector<double> volume;
  double spacing = 0;
};

constexpr double inner = 0.75, outer = 1.0;

Wall make_wall(bool axial, int layers, double jitter) {
  Wall wall;
  wall.spacing = (outer - inner) / layers;
  const int columns = int(std::lround(pi * 0.5 * (inner + outer) / wall.spacing));
  const double angle = pi / columns;
  for (int k = 0; k < columns; ++k) {
    for (int l = 0; l < layers; ++l) {
      const double a = inner + l * wall.spacing, b = a + wall.spacing;
      const double R = 0.5 * (a + b) + jitter * wall.spacing * std::sin(7.0 * (k * layers + l)),
                   at = angle *
                        (k + 0.5 + (k > 0 && k + 1 < columns ? jitter * std::sin(11.0 * (k * layers + l)) : 0.0));
      wall.position.emplace_back(R * std::cos(at), R * std::sin(at));
      wall.volume.push_back(axial ? 2.0 * pi / 3.0 * (b * b * b - a * a * a) *
                                        (std::cos(k * angle) - std::cos(k * angle + angle))
                                  : 0.5 * (b * b - a * a) * angle);
    }
  }
  return wall;
}

// Rate of decay of the amplitude of f, as <f, L f>/<f, f> with unit diffusivity.
double rate(const JumpGraph& graph, const Wall& wall, const std::vector<double>& f) {
  double above = 0, below = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p)
      above += 0.5 * wall.volume[i] * graph.coupling[p] * std::pow(f[graph.target[p]] - f[i], 2);
    below += wall.volume[i] * f[i] * f[i];
  }
  return above / below;
}

// The slowest mode round a thick shell by a fine finite-element solution of its radial equation, by the Rayleigh
// quotient of g(r) cos(theta) with the best g = r + c/r^m (m = 1 plane, 2 axial), which is harmonic and right to second
// order in thickness.
double exact_rate(bool axial) {
  const int n = 2000;
  double best = 1e9;
  for (double c = 0.0; c < 2.0; c += 0.0005) {
    double above = 0, below = 0;
    for (int k = 0; k < n; ++k) {
      const double r = inner + (k + 0.5) * (outer - inner) / n, m = axial ? 2.0 : 1.0;
      const double g = r + c * std::pow(r, -m), d = 1.0 - m * c * std::pow(r, -m - 1.0), w = axial ? r * r : r;
      above += w * (d * d + (axial ? 2.0 : 1.0) * g * g / (r * r));
      below += w * g * g;
    }
    best = std::min(best, above / below);
  }
  return best;
}

std::vector<double> mode(const Wall& wall, bool axial) {
  // the best c of exact_rate makes g'(r) vanish in the middle of the wall
  const double middle = 0.5 * (inner + outer), m = axial ? 2.0 : 1.0, c = std::pow(middle, m + 1.0) / m;
  std::vector<double> f;
  for (const auto& x : wall.position) f.push_back((x.norm() + c * std::pow(x.norm(), -m)) * x[0] / x.norm());
  return f;
}

class Both : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(TensorGraph, Both, ::testing::Bool());

TEST_P(Both, RateOfTheCosineModeIsRight) {
  const bool axial = GetParam();
  for (const auto& [jitter, bound] : {std::pair{0.0, 0.005}, std::pair{0.1, 0.01}}) {
    const auto wall = make_wall(axial, 6, jitter);
    const auto graph = make_tensor_graph({wall.position, wall.volume, 2.6 * wall.spacing, axial, 1.0});
    const double exact = exact_rate(axial);
    EXPECT_NEAR(rate(graph, wall, mode(wall, axial)), exact, bound * exact) << jitter;
  }
}

TEST_P(Both, CouplingsArePositiveAndInDetailedBalance) {
  const auto wall = make_wall(GetParam(), 6, 0.1);
  const auto graph = make_tensor_graph({wall.position, wall.volume, 2.6 * wall.spacing, GetParam(), 1.0});
  for (std::size_t i = 0; i < wall.volume.size(); ++i) {
    for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      EXPECT_GE(graph.coupling[p], 0.0);
      const auto j = graph.target[p];
      for (auto q = graph.first[j]; q < graph.first[j + 1]; ++q)
        if (graph.target[q] == i) {
          EXPECT_NEAR(wall.volume[i] * graph.coupling[p], wall.volume[j] * graph.coupling[q],
                      1e-12 * wall.volume[i] * graph.coupling[p]);
        }
    }
  }
}

}  // namespace
}  // namespace shmoo::rdme::testing
