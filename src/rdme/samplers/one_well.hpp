#pragma once
// The exact method where all is one well: no place to look for, only a reaction to choose. Among few reactions the
// next one is found along their sums (Gillespie 1977, J. Phys. Chem. 81, 2340), among many by composition and rejection
// (groups.hpp), so that an event costs the same among ten as among a thousand.
#include <cstdint>
#include <vector>

#include "rdme/propensity.hpp"
#include "rdme/sampler.hpp"
#include "rdme/samplers/groups.hpp"
#include "rdme/words.hpp"

namespace shmoo::rdme {

class OneWell final : public Sampler {
 public:
  explicit OneWell(const Network& network);

  std::shared_ptr<const JumpTables> prepare(const Voxels& voxels) const override;
  using Sampler::bind;
  void bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) override;
  void amounts_changed() override { derived_ = false; }
  void watch(EventWatch* watch) override { watch_ = watch; }
  void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) override;

 private:
  static constexpr std::size_t few = 8;  // reactions
  struct Change {
    std::int64_t* count;  // null: a deterministic species
    double* amount;
    std::int64_t by;
  };
  void flatten();
  void derive_all();
  void refresh(int reaction);
  bool pass(const Window& window, double origin, AttemptSequence& sequence);
  double sum() const;
  int choose(double uniform, double& rest) const;
  void fire(int reaction);

  const Network& network_;
  Propensities propensities_;
  State* state_ = nullptr;
  EventWatch* watch_ = nullptr;
  bool derived_ = false;
  std::size_t running_ = 0;           // sampled reactions
  std::vector<double> value_;         // propensities by reaction; those that are not sampled are 0
  Groups groups_;                     // of reactions, where they are many
  std::vector<std::size_t> first_;    // [reactions + 1] of its changes
  std::vector<Change> changes_;       // of all reactions
  std::vector<std::int64_t> events_;  // by reaction, of this advance
};

}  // namespace shmoo::rdme
