#include "rdme/tensor_graph.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <numbers>

#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::rdme {
namespace {

using Vec = base::Vec<2>;
using Mat = base::Mat<2>;
using Moments = Eigen::Matrix3d;

// Particles, and behind them the images of those near the axis.
struct Places {
  std::vector<Vec> position;
  std::vector<std::uint32_t> particle;
  std::vector<double> area;  // [m^2] in the plane
};

double width(const HalfPlane& plane, double y) { return plane.axial ? 2.0 * std::numbers::pi * y : plane.depth; }

Places with_images(const HalfPlane& plane) {
  Places all;
  for (std::size_t i = 0; i < plane.position.size(); ++i) {
    all.position.push_back(plane.position[i]);
    all.particle.push_back(std::uint32_t(i));
    all.area.push_back(plane.volume[i] / width(plane, plane.position[i][1]));
  }
  for (std::size_t i = 0; i < plane.position.size(); ++i) {
    if (plane.position[i][1] > plane.reach) continue;
    all.position.emplace_back(plane.position[i][0], -plane.position[i][1]);
    all.particle.push_back(std::uint32_t(i));
    all.area.push_back(all.area[i]);
  }
  return all;
}

// The normalising tensor of one particle.
Mat normaliser(const Places& all, const sph::WendlandC2<2>& kernel, std::span<const std::uint32_t> row, std::size_t i) {
  Moments moments = Moments::Zero();  // of e (x) e against C's entries xx, yy, xy
  for (const auto j : row) {
    const Vec apart = all.position[j] - all.position[i];
    const double r = apart.norm(), weight = all.area[j] * kernel.F(r) * r * r;
    const Vec e = apart / r;
    const Eigen::Vector3d ee(e[0] * e[0], e[1] * e[1], e[0] * e[1]), contract(ee[0], ee[1], 2.0 * ee[2]);
    moments += weight * ee * contract.transpose();
  }
  const Eigen::Vector3d C = moments.fullPivLu().solve(Eigen::Vector3d(1.0, 1.0, 0.0));
  return (Mat() << C[0], C[2], C[2], C[1]).finished();
}

}  // namespace

JumpGraph make_tensor_graph(const HalfPlane& plane) {
  const auto all = with_images(plane);
  const std::size_t particles = plane.position.size();
  sph::NeighbourRows<2> rows;
  base::Box<2> box{all.position.front(), all.position.front(), {}};
  for (const auto& x : all.position) box.lower = box.lower.cwiseMin(x), box.upper = box.upper.cwiseMax(x);
  rows.build(all.position, box, plane.reach);
  const sph::WendlandC2<2> kernel(plane.reach);
  std::vector<Mat> C;
  for (std::size_t i = 0; i < particles; ++i) C.push_back(normaliser(all, kernel, rows.row(i), i));
  JumpGraph graph;
  graph.first.push_back(0);
  for (std::size_t i = 0; i < particles; ++i) {
    std::map<std::uint32_t, double> by_target;  // [1/m^2]
    for (const auto j : rows.row(i)) {
      const std::uint32_t k = all.particle[j];
      if (k == i) continue;
      const bool image = j >= particles;
      Vec apart = all.position[j] - all.position[i];
      const double r = apart.norm(), middle = 0.5 * std::abs(all.position[i][1] + all.position[j][1]);
      const Vec e = apart / r;
      Mat other = C[k];
      if (image) other(0, 1) = other(1, 0) = -other(0, 1);
      const double weight = 2.0 * all.area[i] * all.area[j] * kernel.F(r) * 0.5 * e.dot((C[i] + other) * e);
      by_target[k] += std::max(0.0, weight) * width(plane, middle) / plane.volume[i];
    }
    for (const auto& [k, coupling] : by_target) {
      graph.target.push_back(k);
      graph.coupling.push_back(coupling);
    }
    graph.first.push_back(graph.target.size());
  }
  return graph;
}

}  // namespace shmoo::rdme
