#pragma once
// Particles in clusters of eight that stand close together, and for each cluster the places within a cutoff of it: its
// particles lie in the lanes of a vector and meet their partners one by one (Pall & Hess 2013, "A flexible algorithm
// for calculating pair interactions on SIMD architectures"). The first places are those of the clusters, the last
// cluster of a column filled up with copies of its last particle; then come the images of particles beyond sides,
// shifted where the axis is periodic and mirrored where it is not. Coordinates are whole multiples of a tiny length, so
// that both views of a pair are opposite to the bit.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"
#include "base/lanes.hpp"
#include "sph/columns.hpp"

namespace shmoo::sph {

template <int D>
class Clusters {
 public:
  using Vec = base::Vec<D>;
  using Coordinates = std::array<base::LaneArray, D>;  // [m] of all places, and room for a vector beyond the last

  // Lists all places within `cutoff` [m] of a cluster. Positions must be wrapped along periodic axes, whose extents are
  // at least two cutoffs.
  Clusters(std::span<const Vec> positions, const base::Box<D>& box, double cutoff);

  std::size_t particles() const { return place_.size(); }
  std::size_t size() const { return count_.size(); }                        // clusters
  std::size_t count(std::size_t cluster) const { return count_[cluster]; }  // its particles, the first of its places
  std::size_t places() const { return particle_.size(); }
  std::uint32_t particle(std::size_t place) const { return particle_[place]; }
  std::uint32_t place(std::size_t particle) const { return place_[particle]; }  // not that of an image
  std::span<const std::uint32_t> partners(std::size_t cluster) const {
    const auto& [chunk, begin, size] = list_[cluster];
    return {partners_[chunk].data() + begin, size};
  }

  // Where all places are once the particles stand at `positions`.
  Coordinates coordinates(std::span<const Vec> positions) const;

 private:
  struct List {
    std::uint32_t chunk = 0, begin = 0, size = 0;
  };
  using Passage = std::array<std::int8_t, D>;  // by axis: 0, or 1 through the lower and 2 through the upper side

  void measure(std::span<const Vec> positions);
  void lay(std::span<const std::uint32_t> order);
  void add_images();
  void list_partners(std::size_t chunk, const Coordinates& at);
  void append(std::size_t chunk, List& list, const Coordinates& at, const Vec& lower, const Vec& upper,
              std::size_t begin, std::size_t end);
  Vec snapped(const Vec& x) const;
  Vec passed(Vec x, const Passage& passage) const;

  base::Box<D> box_;
  double cutoff_;
  Vec origin_ = Vec::Zero();                     // [m] of coordinates
  Vec begin_ = Vec::Zero(), end_ = Vec::Zero();  // [m] of the box, in coordinates
  double grain_ = 0;                             // [m] 1.5 2^52 times the length that coordinates are multiples of
  ColumnGrid<D> grid_;
  Columns<D> columns_, image_columns_;
  std::vector<Vec> built_at_, anchor_;  // [m] position at the beginning, and its coordinates
  std::vector<std::uint32_t> particle_, place_;
  std::vector<Passage> passage_;  // of images
  std::vector<std::uint32_t> count_;
  std::vector<std::uint32_t> padding_;  // places before a column beyond its particles
  std::vector<List> list_;
  std::vector<std::vector<std::uint32_t>> partners_;  // by chunk
};

extern template class Clusters<1>;
extern template class Clusters<2>;
extern template class Clusters<3>;

}  // namespace shmoo::sph
