#pragma once
// Effects that act on particles one by one: O(N), so a virtual call per sweep is fine.
#include <memory>
#include <span>
#include <vector>

#include "hydro/scales.hpp"
#include "sph/particles.hpp"

namespace shmoo::hydro {

// The columns that a body effect reads and adds to.
template <int D>
struct BodyView {
  const std::vector<base::Vec<D>>& position;  // [m]
  const std::vector<base::Vec<D>>& velocity;  // [m/s]
  std::vector<base::Vec<D>>& acceleration;    // [m/s^2]
  const std::vector<std::uint32_t>& id;       // persistent
  double dt;                                  // [s] step in which the acceleration will act
};

template <int D>
class BodyEffect {
 public:
  virtual ~BodyEffect() = default;
  virtual const char* name() const = 0;
  virtual void limits(const Scales<D>&, std::vector<StepLimit>&) const {}
  virtual void describe(std::vector<Derived>&) const {}
  virtual void apply(const BodyView<D>& view, std::span<const std::uint32_t> particles) const = 0;
};

template <int D>
using BodyEffects = std::vector<std::unique_ptr<BodyEffect<D>>>;

}  // namespace shmoo::hydro
