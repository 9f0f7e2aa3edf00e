#pragma once
// The velocity that a scene gives the fluid or a solid at the start, or what enters, from numbers or expressions over
// x, y, z [m], t [s] and the parameters.
#include <array>
#include <memory>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace mu {
class Parser;
}

namespace shmoo::hydro {

template <int D>
class InitialVelocity {
 public:
  // Throws base::InputError where an expression cannot be used.
  explicit InitialVelocity(const scene::Scene& scene)
      : InitialVelocity(scene.flow.initial_velocity, scene.parameters) {}
  InitialVelocity(const std::vector<scene::Quantity>& given, const std::map<std::string, double>& parameters);
  InitialVelocity(InitialVelocity&&) noexcept;
  ~InitialVelocity();

  base::Vec<D> operator()(const base::Vec<D>& position, double t = 0.0) const;  // [m/s]; not thread-safe

 private:
  struct Component {
    double value = 0;
    std::unique_ptr<mu::Parser> parser;  // where there is an expression
  };
  std::array<Component, D> components_;
  std::unique_ptr<std::array<double, 4>> variables_;  // x, y, z, t; the parsers point to them
};

extern template class InitialVelocity<2>;
extern template class InitialVelocity<3>;

}  // namespace shmoo::hydro
