#pragma once
// Neighbour rows of particles that move little from look to look: pairs are listed with a skin around the reach and
// kept until a particle has moved through half of it.
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "sph/neighbours.hpp"

namespace shmoo::sph {

template <int D>
class SkinRows {
 public:
  using Vec = base::Vec<D>;

  // `skin` [m] is made smaller where a periodic box leaves less room.
  SkinRows(const base::Box<D>& box, double reach, double skin);

  // All pairs within reach at these positions, and some beyond, ascending. Which of those beyond are there depends on
  // what was asked before. May be called from any thread.
  std::shared_ptr<const NeighbourRows<D>> at(std::span<const Vec> positions);

  void forget();

 private:
  struct Built {
    std::vector<Vec> at;
    NeighbourRows<D> rows;
  };
  bool serves(const Built& built, std::span<const Vec> positions) const;
  std::shared_ptr<const Built> build(std::span<const Vec> positions) const;

  base::Box<D> box_;
  double reach_, skin_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<const Built>> kept_;  // the latest first
};

extern template class SkinRows<1>;
extern template class SkinRows<2>;
extern template class SkinRows<3>;

}  // namespace shmoo::sph
