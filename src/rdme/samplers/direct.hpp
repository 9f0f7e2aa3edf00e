#pragma once
// Gillespie's direct method (1977, J. Phys. Chem. 81, 2340) over all channels of all voxels, as in the textbook: the
// reference that every other method is measured against. The cost of an event grows with the number of voxels.
#include <vector>

#include "rdme/propensity.hpp"
#include "rdme/sampler.hpp"
#include "rdme/surface/beside.hpp"

namespace shmoo::rdme {

class Direct final : public Sampler {
 public:
  explicit Direct(const Network& network) : network_(network), propensities_(network) {}

  std::shared_ptr<const JumpTables> prepare(const Voxels&) const override { return nullptr; }
  using Sampler::bind;
  void bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) override;
  void amounts_changed() override {}
  void watch(EventWatch* watch) override { watch_ = watch; }
  void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) override;

 private:
  enum class Kind { reaction, jump, exit, entry };
  struct Channel {
    Kind kind;
    std::uint32_t voxel;
    int index;             // reaction or species
    double rate = 0;       // [1/s] per molecule; of an entry [molecules/s]
    std::uint32_t target;  // of a jump, or the other voxel of a reaction on a surface; else the voxel
  };

  double propensity(const Channel& channel);
  void refresh(std::size_t voxel);
  void refresh_around(std::size_t voxel);
  bool pass(const Window& window, double origin, base::RandomSequence& random);
  void fire(const Channel& channel);

  const Network& network_;
  Propensities propensities_;
  Beside beside_;
  State* state_ = nullptr;
  std::vector<Channel> channels_;      // ascending by voxel
  std::vector<std::size_t> first_;     // [voxels + 1] a voxel's channels
  std::vector<double> value_, total_;  // by channel, by voxel
  Process process_ = Process::both;
  EventWatch* watch_ = nullptr;
};

}  // namespace shmoo::rdme
