#include "hydro/shell/growth.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::hydro {
namespace {

// E/(1 - nu): tension per strain that is equal in both directions of a plate.
double plate_modulus(double G, double K) {
  const double E = 9.0 * K * G / (3.0 * K + G), nu = (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G);
  return E / (1.0 - nu);
}

}  // namespace

Vec2 tangent_at(const Shell& shell, std::size_t i) {
  const auto layers = std::size_t(shell.layers);
  const bool first = i < layers, last = i + layers >= shell.size();
  const auto image = [&] { return Vec2(shell.x[i][0], -shell.x[i][1]); };
  const Vec2 before = first ? image() : shell.x[i - layers], after = last ? image() : shell.x[i + layers];
  return (after - before).normalized();
}

double mean_tension(const Shell& shell, const ShellEnergy& energy, std::size_t i) {
  const auto at = energy.elastic(shell, i);
  const auto sigma = cauchy(ElasticPoint<2>(shell.law, {shell.shear[i], shell.bulk}, at).stress(), at);
  const Vec2 t = tangent_at(shell, i);
  return 0.5 * (t.dot(sigma.P * t) + sigma.hoop);
}

void grow(Shell& shell, const ShellEnergy& energy, const scene::Growth& growth, std::span<const double> concentration,
          double dt) {
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const double phi = growth.coefficient * concentration[i];
    const double stiff = phi * plate_modulus(shell.shear[i], shell.bulk) * dt;
    const double drive = phi * (mean_tension(shell, energy, i) - growth.yield_stress);
    const double gamma = std::max(0.0, (drive + stiff * shell.growth[i]) / (1.0 + stiff));
    const Mat2 F = deformation_gradient(energy.rows()[i], shell.x);
    const Vec2 t = tangent_at(shell, i);
    const Mat2 insertion = Mat2::Identity() + std::expm1(-gamma * dt) * t * t.transpose();
    shell.B[i] = F.inverse() * insertion * F * shell.B[i];
    shell.b[i] *= std::exp(-gamma * dt);
    shell.V0[i] *= std::exp(2.0 * gamma * dt);
    shell.growth[i] = gamma;
  }
}

}  // namespace shmoo::hydro
