#include "sph/fine_zone.hpp"

#include <algorithm>
#include <limits>

namespace shmoo::sph {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-6;  // [spacings]

}  // namespace

template <int D>
FineZone<D>::FineZone(const scene::Scene& scene) : reach_(scene.numerics.reach * scene.domain.spacing) {
  const double tiny = tolerance * scene.domain.spacing;
  for (const auto& refinement : scene.domain.refinements) {
    const auto& shape = std::get<scene::BoxShape>(refinement.shape->form);
    Box box;
    for (int a = 0; a < D; ++a) {
      const auto axis = std::size_t(a);
      box.lower[a] = shape.lower[axis] > scene.domain.lower[axis] + tiny ? shape.lower[axis] : -infinite;
      box.upper[a] = shape.upper[axis] < scene.domain.upper[axis] - tiny ? shape.upper[axis] : infinite;
    }
    boxes_.push_back(box);
  }
}

template <int D>
double FineZone<D>::depth(const Vec& x) const {
  double deepest = -infinite;
  for (const Box& box : boxes_)
    deepest = std::max(deepest, std::min((x - box.lower).minCoeff(), (box.upper - x).minCoeff()));
  return deepest;
}

template <int D>
double FineZone<D>::narrowing(const Vec& x) const {
  return 1.0 - 0.5 * std::clamp(depth(x) / reach_, 0.0, 1.0);
}

template class FineZone<1>;
template class FineZone<2>;
template class FineZone<3>;

}  // namespace shmoo::sph
