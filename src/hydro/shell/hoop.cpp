#include "hydro/shell/hoop.hpp"

#include "hydro/shell/growth.hpp"

namespace shmoo::hydro {

Hoop hoop_at(const Shell& shell, const ShellEnergy& energy, std::size_t i) {
  const auto at = energy.elastic(shell, i);
  const auto sigma = cauchy(ElasticPoint<2>(shell.law, {shell.shear[i], shell.bulk}, at).stress(), at);
  if (shell.axial) return {at.hoop - 1.0, sigma.hoop};
  const Vec2 t = tangent_at(shell, i);
  return {1.0 / Vec2(at.F.inverse() * t).norm() - 1.0, t.dot(sigma.P * t)};
}

}  // namespace shmoo::hydro
