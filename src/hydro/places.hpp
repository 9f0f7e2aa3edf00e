#pragma once
// Of particles that come and go: ids, none of which is given twice, and the places that they have in what is recorded,
// whole numbers below voxels + reserve. Who comes gets the lowest free place, which it leaves free again.
#include <functional>
#include <queue>
#include <vector>

#include "sph/fill.hpp"

namespace shmoo::hydro {

// Of a particle that has no place in what is recorded.
inline constexpr std::uint32_t no_place = 0xFFFFFFFF;

class Places {
 public:
  template <int D>
  explicit Places(const sph::Filling<D>& filling)
      : voxels_(filling.voxels), reserve_(filling.reserve), next_id_(std::uint32_t(filling.particles.size())) {}

  // Asks for the column `place`, and gives every particle inside the domain one.
  template <int D>
  void prepare(sph::Particles<D>& particles) {
    column_ = &particles.template require<std::uint32_t>("place", "1");
    for (std::size_t i = 0; i < particles.size(); ++i)
      (*column_)[i] = particles.id[i] < voxels_ ? particles.id[i] : no_place;
    for (std::size_t k = 0; k < reserve_; ++k) free_.push(std::uint32_t(voxels_ + k));
  }

  const std::vector<std::uint32_t>& of_particles() const { return column_->values(); }
  std::uint32_t of(std::size_t particle) const { return (*column_)[particle]; }
  std::size_t all() const { return voxels_ + reserve_; }
  std::size_t free() const { return next_id_ == no_place ? 0 : free_.size(); }

  // One must be free.
  std::uint32_t take(std::size_t particle) {
    (*column_)[particle] = free_.top();
    free_.pop();
    return of(particle);
  }
  std::uint32_t leave(std::size_t particle) {
    const std::uint32_t place = of(particle);
    free_.push(place);
    (*column_)[particle] = no_place;
    return place;
  }
  std::uint32_t new_id() { return next_id_++; }

 private:
  std::size_t voxels_, reserve_;
  std::uint32_t next_id_;
  sph::Column<std::uint32_t>* column_ = nullptr;
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_;  // the lowest first
};

}  // namespace shmoo::hydro
