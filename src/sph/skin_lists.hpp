#pragma once
// Lists of neighbours of particles that move little from look to look: made with a skin around the reach and kept until
// a particle has moved through half of it.
#include <omp.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/box.hpp"

namespace shmoo::sph {

// `Lists` are made from positions, a box and a cutoff [m].
template <int D, class Lists>
class SkinLists {
 public:
  using Vec = base::Vec<D>;

  // `skin` [m] is made smaller where a periodic box leaves less room.
  SkinLists(const base::Box<D>& box, double reach, double skin) : box_(box), reach_(reach), skin_(skin) {
    for (int a = 0; a < D; ++a)
      if (box.periodic[std::size_t(a)]) skin_ = std::min(skin_, 0.5 * box.size()[a] - reach);
    skin_ = std::max(skin_, 0.0);
  }

  // All pairs within reach at these positions, and some beyond. Which of those beyond are there depends on what was
  // asked before. May be called from any thread.
  std::shared_ptr<const Lists> at(std::span<const Vec> positions) {
    const auto lists_of = [](const std::shared_ptr<const Built>& built) {
      return std::shared_ptr<const Lists>(built, &built->lists);
    };
    {
      const std::lock_guard lock(mutex_);
      for (const auto& built : kept_)
        if (serves(*built, positions)) return lists_of(built);
    }
    const auto built = std::make_shared<const Built>(
        Built{{positions.begin(), positions.end()}, Lists(positions, box_, reach_ + skin_)});
    const std::lock_guard lock(mutex_);
    kept_.insert(kept_.begin(), built);
    if (kept_.size() > std::size_t(omp_get_num_procs())) kept_.pop_back();
    return lists_of(built);
  }

  void forget() {
    const std::lock_guard lock(mutex_);
    kept_.clear();
  }

 private:
  struct Built {
    std::vector<Vec> at;
    Lists lists;
  };

  bool serves(const Built& built, std::span<const Vec> positions) const {
    if (positions.size() != built.at.size()) return false;
    const double limit = 0.25 * skin_ * skin_;
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (!(box_.nearest(positions[i] - built.at[i]).squaredNorm() <= limit)) return false;
    return true;
  }

  base::Box<D> box_;
  double reach_, skin_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<const Built>> kept_;  // the latest first
};

}  // namespace shmoo::sph
