#pragma once
// The reactions of all voxels over a part of a splitting step: groups of voxels shared out among threads, each with
// reactions of its own kind of object (`Reactions`: voxel_reactions.hpp or leaping_reactions.hpp). The bits are the
// same for any number of threads.
#include <functional>
#include <vector>

#include "rdme/propensity.hpp"
#include "rdme/samplers/share_groups.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

template <class Reactions>
class ReactionsInGroups {
 public:
  // `make` one for a thread; threads are worth starting from so many voxels on.
  ReactionsInGroups(std::function<Reactions()> make, std::uint32_t worth_threads)
      : make_(std::move(make)), worth_threads_(worth_threads) {}

  void bind(const Voxels& voxels, State& state) {
    voxels_ = &voxels;
    state_ = &state;
    for (auto& one : of_thread_) one.bind(voxels, state);
  }

  // Calls work(reactions, begin, end, windows) for the groups [begin, end) of voxels.
  template <class Work>
  void advance(double t, double dt, Work work) {
    const auto voxels = static_cast<std::uint32_t>(voxels_->size());
    const auto threads = voxels < worth_threads_ ? std::size_t{1} : static_cast<std::size_t>(omp_get_max_threads());
    while (of_thread_.size() < threads) {
      of_thread_.push_back(make_());
      of_thread_.back().bind(*voxels_, *state_);
    }
    const std::vector<Window>& windows = of_thread_[0].propensities().windows(t, dt);
    share_groups(voxels, threads, [&](std::uint32_t begin, std::uint32_t end, std::size_t thread) {
      work(of_thread_[thread], begin, end, windows);
    });
  }

  void close_books() {
    for (auto& one : of_thread_) one.close_books();
  }

 private:
  std::function<Reactions()> make_;
  std::uint32_t worth_threads_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  std::vector<Reactions> of_thread_;
};

}  // namespace shmoo::rdme
