#pragma once
// Jumps by kernel weights that are not written down: of a voxel only a bound of the sum of its couplings is known, and
// where a molecule jumps is found when it does, by rejection; at the bound some jumps fail (thinning: Lewis and Shedler
// 1979), so that the law is exact. Where few molecules jump before the particles move on, this is much cheaper than
// rows of weights. The couplings are those of kernel_graph.hpp.
#include <memory>
#include <span>
#include <vector>

#include "rdme/jump_graph.hpp"
#include "rdme/samplers/word_stream.hpp"
#include "sph/clusters.hpp"

namespace shmoo::rdme {

class UnlistedJumps {
 public:
  virtual ~UnlistedJumps() = default;

  std::size_t size() const { return sum_.size(); }     // voxels
  double sum(std::size_t i) const { return sum_[i]; }  // [1/m^2] the voxel's couplings, or a bound of that

  // Where a molecule of voxel i jumps that does so at the rate of the sum, which must not be 0; i: the jump fails.
  virtual std::uint32_t target(std::uint32_t i, WordStream& words) const = 0;

  // All jumps out of voxel i; a target may be there more than once.
  virtual void row(std::uint32_t i, std::vector<std::uint32_t>& target, std::vector<double>& coupling) const = 0;

 protected:
  std::vector<double> sum_;
};

// Whether jumps of such a habitat can stay unlisted: its contacts are made from rows.
bool can_stay_unlisted(const Habitat& habitat);

// `clusters` with all pairs within the kernel's reach. Copies what it needs of the places.
template <int D>
std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<D>& places,
                                                         std::shared_ptr<const sph::Clusters<D>> clusters,
                                                         const sph::AnyKernel<D>& kernel, const Habitat& habitat);

extern template std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<1>&,
                                                                         std::shared_ptr<const sph::Clusters<1>>,
                                                                         const sph::AnyKernel<1>&, const Habitat&);
extern template std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<2>&,
                                                                         std::shared_ptr<const sph::Clusters<2>>,
                                                                         const sph::AnyKernel<2>&, const Habitat&);
extern template std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<3>&,
                                                                         std::shared_ptr<const sph::Clusters<3>>,
                                                                         const sph::AnyKernel<3>&, const Habitat&);

}  // namespace shmoo::rdme
