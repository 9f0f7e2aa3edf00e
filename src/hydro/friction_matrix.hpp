#pragma once
// The pair friction of viscosity as a matrix G: (G v)_i = (1/m) sum_j [a_ij v_ij + b_ij e (e.v_ij)], a_ij = alpha V_i
// V_j F_ij s_ij, b_ij likewise with beta. One coefficient per near pair of a block is kept, or two.
#include <array>
#include <vector>

#include "hydro/effects/viscosity.hpp"
#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

template <int D>
class FrictionMatrix {
 public:
  using Field = std::array<LaneArray, D>;  // by slot

  explicit FrictionMatrix(const Viscosity<D>& viscosity) : viscosity_(viscosity) {}

  // At the present positions; slots' volume and scaling are up to date.
  void prepare(const State<D>& state, const sph::AnyKernel<D>& kernel);
  // result <- v + h G v of the particles that flow. Velocities of images and solids in v are up to date.
  void apply(const Blocks<D>& blocks, double h, const Field& v, Field& result);
  // sum_i a_i.b_i over the particles that flow, in the order of blocks, so that bits do not depend on threads.
  double product(const Field& a, const Field& b);

  std::size_t bytes() const { return sizeof(double) * (across_.size() + along_.size() + weight_.size()); }

 private:
  void resize(const Blocks<D>& blocks);
  template <class Kernel>
  void prepare_block(const State<D>& state, const Kernel& kernel, std::size_t b);

  Viscosity<D> viscosity_;
  std::vector<std::size_t> first_;  // of a block's pairs
  LaneArray across_, along_;        // a_ij/m [1/s], b_ij/(m r^2) [1/(m^2 s)]
  LaneArray weight_;                // 1 for particles, 0 for copies
  std::vector<double> parts_;
};

extern template class FrictionMatrix<2>;
extern template class FrictionMatrix<3>;

}  // namespace shmoo::hydro
