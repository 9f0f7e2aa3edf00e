#pragma once
// The flow's neighbour rows. Particles are first sorted by cell, so that partners lie close in memory; rows hold all
// pairs within the kernel's reach plus a skin and stay valid until a particle has moved half the skin. Rows are padded
// with the particle itself, which contributes exactly nothing to any sum over differences.
#include <array>
#include <cstdint>
#include <vector>

#include "base/box.hpp"
#include "hydro/lanes.hpp"
#include "sph/cells.hpp"
#include "sph/particles.hpp"

namespace shmoo::hydro {

template <int D>
class PairRows {
 public:
  using Vec = base::Vec<D>;

  PairRows(const base::Box<D>& box, double reach, double skin);

  // Sorts the particles and lists their pairs: a fluid particle's with all others, a solid particle's with fluid only.
  void build(sph::Particles<D>& particles);
  // True where some particle has moved so far since build() that a pair may be missing.
  bool outdated(const std::vector<Vec>& position) const;

  std::uint64_t first(std::size_t i) const { return first_[i]; }  // first .. first(i + 1): a multiple of `lanes`
  std::uint32_t count(std::size_t i) const { return count_[i]; }  // without the padding
  const std::int32_t* partner() const { return partner_.data(); }
  std::uint64_t pairs() const;  // directed, without the padding
  std::size_t slots() const { return partner_.size(); }
  double cutoff() const { return reach_ + skin_; }  // [m]
  const std::array<Axis, D>& axes() const { return axes_; }
  std::uint64_t builds() const { return builds_; }

  // One number for each slot of the rows: F_ij [1/m^(D+2)] in rows of fluid, W_ij [1/m^D] in rows of solids.
  std::vector<double> weight;

  const std::vector<std::uint32_t>& fluid() const { return fluid_; }          // particles that flow, ascending
  const std::vector<std::uint32_t>& solid() const { return solid_; }          // solid particles with fluid about
  const std::vector<std::uint32_t>& near_wall() const { return near_wall_; }  // fluid particles with a solid about

 private:
  struct Chunk {
    std::vector<std::int32_t> partner;
  };
  void list_chunk(const sph::Particles<D>& particles, std::size_t chunk);
  void classify(const sph::Particles<D>& particles);

  base::Box<D> box_;
  double reach_, skin_;
  std::array<Axis, D> axes_;
  sph::Cells<D> cells_;
  std::vector<Vec> built_at_;
  std::vector<Chunk> chunks_;
  std::vector<std::uint64_t> first_;
  std::vector<std::uint32_t> count_;
  std::vector<std::int32_t> partner_;
  std::vector<std::uint32_t> fluid_, solid_, near_wall_;
  std::uint64_t builds_ = 0;
};

extern template class PairRows<2>;
extern template class PairRows<3>;

}  // namespace shmoo::hydro
