#pragma once
// Tau-leaping: as the split method, half a step of reactions, a step of diffusion, half a step of reactions, but with
// the reactions of a voxel in leaps where these pay (leaping_reactions.hpp). Diffusion is sampled without events and
// exactly (uniformised.hpp), so nothing is ever negative. Where nothing moves, reactions run through the whole step and
// only the error of leaps is left.
#include "rdme/sampler.hpp"
#include "rdme/samplers/leaping_reactions.hpp"
#include "rdme/samplers/reactions_in_groups.hpp"
#include "rdme/samplers/uniformised.hpp"

namespace shmoo::rdme {

class TauLeaping final : public Sampler {
 public:
  // `tolerance`: epsilon of the leap condition, in (0, 1).
  TauLeaping(const Network& network, double tolerance);

  std::shared_ptr<const JumpTables> prepare(const Voxels& voxels) const override;
  using Sampler::bind;
  void bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) override;
  void amounts_changed() override {}
  void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) override;

 private:
  void react(double t, double dt, const Address& address, std::uint32_t half);

  const Network& network_;
  ReactionsInGroups<LeapingReactions> reactions_;
  UniformisedDiffusion diffusion_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  std::shared_ptr<const JumpTables> tables_;
  bool anything_moves_ = false;
};

}  // namespace shmoo::rdme
