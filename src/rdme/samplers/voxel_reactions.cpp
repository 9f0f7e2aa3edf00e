#include "rdme/samplers/voxel_reactions.hpp"

#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {

VoxelReactions::VoxelReactions(const Network& network)
    : network_(network),
      propensities_(network),
      value_(network.reactions().size(), 0.0),
      events_(network.reactions().size(), 0) {}

void VoxelReactions::bind(const Voxels& voxels, State& state) {
  voxels_ = &voxels;
  state_ = &state;
  propensities_.bind(voxels, state);
}

void VoxelReactions::react(std::uint32_t begin, std::uint32_t end, std::span<const Window> windows,
                           AttemptSequence sequence) {
  sequence_ = &sequence;
  next_ = Attempts::size;
  for (std::uint32_t i = begin; i < end; ++i)
    for (const Window& window : windows) react(i, window);
}

VoxelReactions::Draw VoxelReactions::draw() {
  if (next_ == Attempts::size) {
    sequence_->next(attempts_);
    next_ = 0;
  }
  const std::size_t k = next_++;
  return {attempts_.wait[k], attempts_.choice[k]};
}

void VoxelReactions::react(std::uint32_t voxel, const Window& window) {
  const std::uint16_t material = voxels_->material[voxel];
  const std::span<const int> running = network_.sampled_in(material);
  propensities_.set_window(window);
  double sum = 0;
  for (int r : running) sum += value_[r] = propensities_(r, voxel);
  for (double left = window.to - window.from; sum > 0;) {
    const Draw now = draw();
    if ((left -= now.wait / sum) <= 0) return;
    double rest = now.choice * sum;
    int fires = -1;
    for (int r : running) {
      if (value_[r] <= 0) continue;
      fires = r;
      if (rest < value_[r]) break;
      rest -= value_[r];
    }
    if (!propensities_.happens(fires, voxel, window.to - left, rest, value_[fires])) continue;
    change_numbers(*state_, network_, network_.reactions()[fires], voxel);
    ++events_[fires];
    for (int r : network_.after_reaction(fires, material)) value_[r] = propensities_(r, voxel);
    sum = 0;
    for (int r : running) sum += value_[r];
  }
}

}  // namespace shmoo::rdme
