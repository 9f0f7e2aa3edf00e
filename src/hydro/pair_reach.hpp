#pragma once
// The kernel of a pair in sweeps over blocks. Where all particles have one reach it is the kernel. Where spacings
// differ it has the mean of their reaches, h = hs_i + hs_j, the same from either side: W_h(r) = (H/h)^D W_H(r H/h),
// F_h(r) = (H/h)^(D+2) F_H(r H/h), H the reach that the kernel was made with.
#include "hydro/eights.hpp"
#include "hydro/state.hpp"

namespace shmoo::hydro {

// A kernel, narrowed to h = H/stretch.
template <int D, class Kernel, class Number>
struct Narrowed {
  const Kernel& kernel;
  Number stretch;

  Number W(const Number& r) const { return area() * kernel.W(Number(r * stretch)); }
  Number F(const Number& r) const { return area() * stretch * stretch * kernel.F(Number(r * stretch)); }

 private:
  Number area() const {
    Number product = stretch;
    for (int a = 1; a < D; ++a) product = product * stretch;
    return product;
  }
};

template <int D, class Kernel>
class OneReach {
 public:
  static constexpr bool differ = false;
  struct Own {};

  OneReach(const State<D>& state, const Kernel& kernel)
      : kernel_(kernel), limit_(kernel.reach() * kernel.reach()), mass_(state.scales.mass) {}

  Own own(std::size_t) const { return {}; }
  const Kernel& of(const Own&, std::size_t) const { return kernel_; }
  bool any_within(const Lane& r2, const Own&, std::size_t) const { return any_below(r2, limit_); }
  double mass(std::size_t) const { return mass_; }  // [kg/m^(3-D)]

 private:
  const Kernel& kernel_;
  double limit_, mass_;
};

template <int D, class Kernel>
class MeanReach {
 public:
  static constexpr bool differ = true;
  struct Own {
    Lane smoothing;  // [m]
  };

  MeanReach(const State<D>& state, const Kernel& kernel) : state_(state), kernel_(kernel), reach_(kernel.reach()) {}

  Own own(std::size_t block) const { return {load(smoothing() + lanes * block)}; }
  Narrowed<D, Kernel, Lane> of(const Own& own, std::size_t slot) const {
    return {kernel_, reach_ / (own.smoothing + smoothing()[slot])};
  }
  bool any_within(const Lane& r2, const Own& own, std::size_t slot) const {
    const Lane h = own.smoothing + smoothing()[slot];
    return any_below(Lane(r2 - h * h), 0.0);
  }
  double mass(std::size_t i) const { return state_.mass(i); }

 private:
  const double* smoothing() const { return state_.rows.blocks.smoothing.data(); }

  const State<D>& state_;
  const Kernel& kernel_;
  double reach_;
};

// Away from the blocks: W_ij of a particle and eight others.
template <int D, class Kernel>
Lane pair_W(const State<D>& state, const Kernel& kernel, std::size_t i, const Eight& eight, const Lane& r) {
  if (!state.smoothing) return kernel.W(r);
  const Lane h = (*state.smoothing)[i] + eight.of(state.smoothing->values());
  return Narrowed<D, Kernel, Lane>{kernel, kernel.reach() / h}.W(r);
}

// F_ij of two particles.
template <int D, class Kernel>
double pair_F(const State<D>& state, const Kernel& kernel, std::size_t i, std::size_t j, double r) {
  if (!state.smoothing) return kernel.F(r);
  const double h = (*state.smoothing)[i] + (*state.smoothing)[j];
  return Narrowed<D, Kernel, double>{kernel, kernel.reach() / h}.F(r);
}

}  // namespace shmoo::hydro
