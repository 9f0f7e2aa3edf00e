#pragma once
// Fluid particles in blocks of eight that stand close together. A block meets its neighbours one by one: its eight
// particles lie in the lanes, the neighbour is the same number in all of them (as GROMACS does with clusters; Pall &
// Hess 2013, "A flexible algorithm for calculating pair interactions on SIMD architectures"). What pair sweeps read
// lies in slots: first those of the blocks, the last block of a column filled up with copies of its last particle; then
// solids and the images of particles beyond periodic sides and in mirrors. Coordinates in slots are whole multiples of
// a tiny length, so that differences, also across a periodic side, are exact and the two views of a pair are opposite
// to the bit.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"
#include "hydro/lanes.hpp"
#include "sph/columns.hpp"
#include "sph/particles.hpp"

namespace shmoo::hydro {

struct Block {
  std::uint32_t first = 0;  // particles first .. first + size - 1 of the store
  std::uint32_t size = 0;
  std::uint32_t chunk = 0;     // whose list its partners are in,
  std::uint32_t begin = 0;     // from here
  std::uint32_t partners = 0;  // slots within the cutoff of the block
  std::uint32_t near = 0;      // how many of them stand within reach of one of the eight now
  bool at_wall = false;        // solids are among them
};

// Where particles differ in reach: those of a pair meet within the mean of theirs.
struct OwnReach {
  const std::vector<double>& smoothing;  // [m] half a reach, by particle
  double largest;                        // [m] of them
};

template <int D>
class Blocks {
 public:
  using Vec = base::Vec<D>;

  using Mirrors = std::array<std::array<bool, 2>, D>;  // [axis][side]

  Blocks(const base::Box<D>& box, double cutoff, double spacing, const Mirrors& mirrors = {})
      : box_(box), mirrors_(mirrors), cutoff_(cutoff), spacing_(spacing) {}

  // Sorts the particles, fluid first, and lists the partners of every block. Positions must be wrapped. `own` is null
  // where all have one reach, which the cutoff is for; else the cutoff is for the largest.
  void build(sph::Particles<D>& particles, const OwnReach* own = nullptr);
  // Takes the coordinates anew. Returns the square of the largest way [m^2] gone since build().
  double follow(const std::vector<Vec>& position);

  std::size_t size() const { return blocks_.size(); }
  Block& operator[](std::size_t b) { return blocks_[b]; }
  const Block& operator[](std::size_t b) const { return blocks_[b]; }
  const std::int32_t* partners(const Block& block) const { return chunks_[block.chunk].partners.data() + block.begin; }
  std::int32_t* near(const Block& block) { return chunks_[block.chunk].near.data() + block.begin; }
  const std::int32_t* near(const Block& block) const { return chunks_[block.chunk].near.data() + block.begin; }

  std::size_t fluid() const { return fluid_; }  // particles that flow: the first ones of the store
  std::size_t slots() const { return coordinate[0].size() - lanes; }  // a vector's worth can be read beyond the last
  std::size_t block_slots() const { return lanes * blocks_.size(); }
  std::uint32_t particle(std::size_t slot) const { return particle_[slot]; }
  std::uint32_t slot(std::size_t particle) const { return slot_[particle]; }  // of one that flows
  std::array<LaneArray, D> coordinate;                                        // [m] of slots
  LaneArray smoothing;                                                        // [m] of slots, where reaches differ

  // Whether a slot holds an image in a mirror across this axis, whose velocity along it is turned round.
  bool mirrored(std::size_t slot, int axis) const {
    return !turned_.empty() && slot >= block_slots() && ((turned_[slot - block_slots()] >> axis) & 1U) != 0;
  }

  // Calls fill(slot, particle) for every slot.
  template <class Fill>
  void for_slots(Fill&& fill) const {
#pragma omp parallel for schedule(static) if (worth_threads(fluid_))
    for (std::size_t s = 0; s < particle_.size(); ++s) fill(s, std::size_t(particle_[s]));
  }
  // The same for solids and images only.
  template <class Fill>
  void for_others(Fill&& fill) const {
#pragma omp parallel for schedule(static) if (worth_threads(4 * (particle_.size() - block_slots())))
    for (std::size_t s = block_slots(); s < particle_.size(); ++s) fill(s, std::size_t(particle_[s]));
  }

  // Calls visit(particle) for the particles that may lie within `cutoff` of where particle i was at build(), each once;
  // where only the fluid is wanted others may be left out.
  template <class Visit>
  void visit_around(std::size_t i, bool only_fluid, Visit&& visit) const {
    const Vec x = anchor_[i];
    const auto each = [&](std::size_t first, const std::uint32_t* particle) {
      return [&visit, first, particle](std::size_t, std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t k = begin; k < end; ++k) visit(particle ? particle[first + k] : k);
      };
    };
    fluid_columns_.visit(x, x, cutoff_, each(0, nullptr));
    if (only_fluid && !fluid_images_) return;
    other_columns_.visit(x, x, cutoff_, each(block_slots(), particle_.data()));
  }

  std::uint64_t partners() const;  // in all lists
  std::size_t bytes() const;

 private:
  struct Chunk {
    std::vector<std::int32_t> partners, near;
  };

  struct Images {
    std::vector<std::uint32_t> source;  // particle
    std::vector<Vec> shift, point;      // [m]
    std::vector<std::uint8_t> turned;   // bit by axis; where there are mirrors
  };
  bool any_mirror() const;
  bool fluid_images_ = false;  // whether any are among the others
  double plane(int axis, int side) const { return snap((side == 0 ? box_.lower : box_.upper)[axis] - origin_[axis]); }
  void add_images(Images& images, int axis) const;
  void measure(const std::vector<Vec>& position);
  void sort(sph::Particles<D>& particles);
  void lay_blocks();
  void add_others();
  template <class Cutoff>
  void list_partners(std::size_t chunk, const Cutoff& cutoff);
  template <class Within>
  void append(Chunk& chunk, Block& block, const Vec& lower, const Vec& upper, std::size_t begin, std::size_t end,
              const Within& within);
  void place_slots();
  double snap(double x) const { return (x + grain_) - grain_; }
  Vec snapped(const Vec& x) const {
    Vec y;
    for (int a = 0; a < D; ++a) y[a] = snap(x[a]);
    return y;
  }

  base::Box<D> box_;
  Mirrors mirrors_;
  double cutoff_, spacing_;
  Vec origin_ = Vec::Zero(), length_ = Vec::Zero();  // [m] of coordinates; of periodic axes, snapped
  double grain_ = 0;                                 // [m] 1.5 2^52 times the length that coordinates are multiples of
  sph::ColumnGrid<D> grid_;
  sph::Columns<D> fluid_columns_, other_columns_;
  std::size_t fluid_ = 0, solids_ = 0;
  std::vector<Vec> built_at_, anchor_, now_;  // [m] position at build(); coordinates then, and now, by particle
  std::vector<Vec> shift_;                    // [m] of solids and images in their slots
  std::vector<std::uint8_t> turned_;          // by such a slot, bit by axis: mirrored; empty without mirrors
  std::vector<Block> blocks_;
  std::vector<Chunk> chunks_;
  std::vector<std::uint32_t> padding_;   // slots before a column beyond its particles
  std::vector<std::uint32_t> particle_;  // by slot
  std::vector<std::uint32_t> slot_;      // by particle that flows
};

extern template class Blocks<2>;
extern template class Blocks<3>;

}  // namespace shmoo::hydro
