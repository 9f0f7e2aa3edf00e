#include "sph/skin_rows.hpp"

#include <omp.h>

#include <algorithm>

namespace shmoo::sph {

template <int D>
SkinRows<D>::SkinRows(const base::Box<D>& box, double reach, double skin) : box_(box), reach_(reach), skin_(skin) {
  for (int a = 0; a < D; ++a)
    if (box.periodic[std::size_t(a)]) skin_ = std::min(skin_, 0.5 * box.size()[a] - reach);
  skin_ = std::max(skin_, 0.0);
}

template <int D>
std::shared_ptr<const NeighbourRows<D>> SkinRows<D>::at(std::span<const Vec> positions) {
  const auto rows_of = [](const std::shared_ptr<const Built>& built) {
    return std::shared_ptr<const NeighbourRows<D>>(built, &built->rows);
  };
  {
    const std::lock_guard lock(mutex_);
    for (const auto& built : kept_)
      if (serves(*built, positions)) return rows_of(built);
  }
  const auto built = build(positions);
  const std::lock_guard lock(mutex_);
  kept_.insert(kept_.begin(), built);
  if (kept_.size() > std::size_t(omp_get_num_procs())) kept_.pop_back();
  return rows_of(built);
}

template <int D>
std::shared_ptr<const typename SkinRows<D>::Built> SkinRows<D>::build(std::span<const Vec> positions) const {
  auto built = std::make_shared<Built>();
  built->rows.build(positions, box_, reach_ + skin_);
  built->rows.sort();
  built->at.assign(positions.begin(), positions.end());
  return built;
}

template <int D>
void SkinRows<D>::forget() {
  const std::lock_guard lock(mutex_);
  kept_.clear();
}

template <int D>
bool SkinRows<D>::serves(const Built& built, std::span<const Vec> positions) const {
  if (positions.size() != built.at.size()) return false;
  const double limit = 0.25 * skin_ * skin_;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!(box_.nearest(positions[i] - built.at[i]).squaredNorm() <= limit)) return false;
  return true;
}

template class SkinRows<1>;
template class SkinRows<2>;
template class SkinRows<3>;

}  // namespace shmoo::sph
