#pragma once
// Two spacings in one flow. A coarse particle that is half a coarse spacing inside the fine zone becomes four fine ones
// on the corners of a square; fine ones that are as far outside join two by two, nearest pairs first, until they are as
// heavy as the coarse ones (Vacondio et al. 2013, "Variable resolution for SPH: a dynamic particle coalescing and
// splitting scheme"). What is in between has come from the other side and waits, so that none flickers. Mass, volume
// and momentum stay. Particles weigh a power of two of each other: sums of masses are exact.
#include <vector>

#include "hydro/places.hpp"
#include "hydro/state.hpp"
#include "sph/fine_zone.hpp"

namespace shmoo::hydro {

template <int D>
class Spacings {
 public:
  using Vec = base::Vec<D>;

  // Throws base::InputError where the scene asks for what two spacings do not know.
  explicit Spacings(const scene::Scene& scene);

  // Asks for the columns of two spacings.
  void prepare(State<D>& state) const;
  // Splits and merges, and gives every particle its reach. The rows must be built anew after it.
  void exchange(State<D>& state, Places& places);

  std::uint64_t splits() const { return splits_; }  // particles so far
  std::uint64_t merges() const { return merges_; }  // pairs so far

 private:
  struct Pair {
    double distance2;           // [m^2]
    std::uint32_t id, partner;  // the smaller id first
    std::uint32_t i, j;         // particles
    auto operator<=>(const Pair&) const = default;
  };
  void measure(State<D>& state) const;
  void split(State<D>& state, Places& places);
  void place_parts(State<D>& state, Places& places, std::uint32_t i, std::size_t first, std::size_t parts) const;
  void merge(State<D>& state, Places& places);
  std::vector<Pair> pairs(const State<D>& state) const;
  void join(State<D>& state, std::uint32_t i, std::uint32_t j) const;

  sph::FineZone<D> zone_;
  std::uint64_t splits_ = 0, merges_ = 0;
};

extern template class Spacings<2>;
extern template class Spacings<3>;

}  // namespace shmoo::hydro
