#pragma once
// Where particles stand at half the spacing. The kernel's reach follows the place alone: inside a border it changes
// evenly over one coarse reach, so that the sums of a particle there see hardly anything of the jump (with a jump of the
// reach itself they are four times as far off), that coarse particles have their whole reach, and that it does not
// matter to it what has been split or merged already.
#include <vector>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace shmoo::sph {

template <int D>
class FineZone {
 public:
  using Vec = base::Vec<D>;

  explicit FineZone(const scene::Scene& scene);

  // [m] how far inside; negative outside. The end of the domain is no border.
  double depth(const Vec& x) const;
  // Of a particle's own reach over the coarse one: 1 outside, 1/2 inside.
  double narrowing(const Vec& x) const;

 private:
  struct Box {
    Vec lower, upper;  // [m]; infinite where the box goes on beyond the domain
  };
  std::vector<Box> boxes_;
  double reach_;  // [m] of coarse particles
};

extern template class FineZone<1>;
extern template class FineZone<2>;
extern template class FineZone<3>;

}  // namespace shmoo::sph
