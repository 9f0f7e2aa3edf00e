#pragma once
// How steady a flow is: the relative change of its velocity field per crossing time L/U. The field is taken at fixed
// places, the centres of a grid of cells, by a least-squares plane through the velocities of each cell's particles, so
// that the motion of particles through a steady field does not count as a change to first order.
#include <limits>
#include <vector>

#include "hydro/fluid.hpp"

namespace shmoo::hydro {

template <int D>
class Steadiness {
 public:
  // Cells are about as wide as the kernel's support.
  explicit Steadiness(const Fluid<D>& fluid);

  // |u(now) - u(last call)|/|u(now)| (root mean square over cells) * (L/U)/(now - last call); infinite at the first
  // call and where no time has passed.
  double measure(const Fluid<D>& fluid);

 private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<base::Vec<D>> sample(const Fluid<D>& fluid) const;  // NaN in cells with too few particles

  base::Box<D> box_;
  std::array<std::size_t, D> cells_{};
  base::Vec<D> width_;
  std::vector<base::Vec<D>> last_;
  double last_time_ = 0;
};

extern template class Steadiness<2>;
extern template class Steadiness<3>;

}  // namespace shmoo::hydro
