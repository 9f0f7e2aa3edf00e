#pragma once
// Reactions and diffusion in turns: half a step of reactions, a step of diffusion, half a step of reactions (Strang
// 1968, SIAM J. Numer. Anal. 5, 506). Each part is exact, so only the splitting error is left, of second order in the
// step. Between voxels nothing is shared within a part: each voxel's reactions are an exact simulation
// (voxel_reactions.hpp), and diffusion is sampled without events (uniformised.hpp). Groups of voxels have random
// numbers of their own, so that threads share a step and the bits are the same for any number of them.
#include "rdme/sampler.hpp"
#include "rdme/samplers/reactions_in_groups.hpp"
#include "rdme/samplers/uniformised.hpp"
#include "rdme/samplers/voxel_reactions.hpp"

namespace shmoo::rdme {

class Split final : public Sampler {
 public:
  explicit Split(const Network& network);

  std::shared_ptr<const JumpTables> prepare(const Voxels& voxels) const override;
  using Sampler::bind;
  void bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) override;
  void amounts_changed() override {}
  void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) override;

 private:
  void react(double t, double dt, const Address& address, std::uint32_t half);

  const Network& network_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  std::shared_ptr<const JumpTables> tables_;
  UniformisedDiffusion diffusion_;
  ReactionsInGroups<VoxelReactions> reactions_;
};

}  // namespace shmoo::rdme
