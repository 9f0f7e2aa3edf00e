#pragma once
// A fluid that cannot leave fills its room for ever; its summed volumes by continuity do not quite. Pressure moves
// particles away from a surface, the transport velocity moves them back, and only the first changes density: left
// alone, mean density rises by 0.1 % a second in a lid-driven cavity. So every few steps all densities are scaled by
// one factor that closes the volume again.
#include <cstdint>
#include <optional>

#include "hydro/state.hpp"

namespace shmoo::hydro {

// Whether no fluid is beside a place that is empty and may be filled.
template <int D>
bool is_enclosed(const sph::Filling<D>& filling);

template <int D>
struct ClosedRoom {
  static constexpr const char* name = "closed room";
  static constexpr std::uint64_t every = 16;  // steps; solids displace fluid in each

  double room = 0;  // [m^D] of fluid and solids together

  // Unless told off, where something makes mean density drift, no side is open and walls leave the room as large as it is: those at
  // rest, turning ones, and straining ones that keep volumes.
  static std::optional<ClosedRoom> choose(const scene::Scene& scene);
  // Takes the room as the fluid now fills it.
  void prepare(const State<D>& state, double solids);
  bool due(std::uint64_t step, double solids) const { return step > 0 && (solids > 0.0 || step % every == 0); }
  // `solids` [m^D] is the volume of elastic bodies.
  void apply(State<D>& state, double solids) const;
};

extern template bool is_enclosed(const sph::Filling<2>&);
extern template bool is_enclosed(const sph::Filling<3>&);
extern template struct ClosedRoom<2>;
extern template struct ClosedRoom<3>;

}  // namespace shmoo::hydro
