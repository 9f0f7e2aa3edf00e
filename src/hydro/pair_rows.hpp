#pragma once
// Who is near whom. Fluid particles meet their neighbours in blocks; where walls are about there are rows as well: of
// every solid particle with the fluid near it, and of every fluid particle near a solid with all its neighbours. Both
// hold all pairs within the kernel's reach plus a skin and stay valid until a particle has moved half the skin.
#include <array>
#include <cstdint>
#include <vector>

#include "base/box.hpp"
#include "hydro/blocks.hpp"
#include "hydro/lanes.hpp"
#include "sph/particles.hpp"

namespace shmoo::hydro {

template <int D>
class PairRows {
 public:
  using Vec = base::Vec<D>;

  // `spacing` [m] is how far apart particles stand, about.
  PairRows(const base::Box<D>& box, double reach, double skin, double spacing,
           const typename Blocks<D>::Mirrors& mirrors = {});

  // Sorts the particles, fluid first, and lists their pairs. `smoothing` [m], half a reach by particle, is null where
  // all have one reach.
  void build(sph::Particles<D>& particles, const std::vector<double>* smoothing = nullptr);
  // Takes the positions into the blocks. False where a pair may be missing, so that they must be built anew.
  bool follow(const sph::Particles<D>& particles);

  Blocks<D> blocks;

  // The row of particle i: first(i) .. first(i) + count(i) - 1 of partner(); empty far from walls.
  std::uint64_t first(std::size_t i) const { return first_[i]; }
  std::uint32_t count(std::size_t i) const { return std::uint32_t(first_[i + 1] - first_[i]); }
  const std::int32_t* partner() const { return partner_.data(); }
  std::vector<double> weight;  // [1/m^D] W_ij in rows of solids: one number for each entry of partner()

  double cutoff() const { return reach_ + skin_; }  // [m]
  const std::array<Axis, D>& axes() const { return axes_; }
  std::uint64_t builds() const { return builds_; }
  std::size_t bytes() const;

  const std::vector<std::uint32_t>& fluid() const { return fluid_; }          // particles that flow, ascending
  const std::vector<std::uint32_t>& solid() const { return solid_; }          // solid particles with fluid about
  const std::vector<std::uint32_t>& near_wall() const { return near_wall_; }  // fluid particles with a solid about

 private:
  struct Chunk {
    std::vector<std::int32_t> partner;
  };
  std::vector<std::uint32_t> rows_wanted(std::size_t particles) const;
  void list_rows(const sph::Particles<D>& particles, const std::vector<double>* smoothing);
  void list_row(const sph::Particles<D>& particles, const std::vector<double>* smoothing, std::size_t i,
                std::vector<std::int32_t>& row) const;

  base::Box<D> box_;
  double reach_, skin_;
  std::array<Axis, D> axes_;
  std::vector<std::uint64_t> first_;
  std::vector<std::int32_t> partner_;
  std::vector<Chunk> chunks_;
  std::vector<std::uint32_t> fluid_, solid_, near_wall_;
  std::uint64_t builds_ = 0;
};

extern template class PairRows<2>;
extern template class PairRows<3>;

}  // namespace shmoo::hydro
