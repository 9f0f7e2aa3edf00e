#include "rdme/samplers/direct.hpp"

#include <algorithm>

#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {

void Direct::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables>) {
  state_ = &state;
  propensities_.bind(voxels, state);
  beside_ = Beside(network_.samples_surfaces() ? voxels.surfaces : std::vector<Surface>{}, voxels.size());
  channels_.clear();
  for (std::uint32_t i = 0; i < voxels.size(); ++i) {
    for (int r : network_.sampled_in(voxels.material[i])) channels_.push_back({Kind::reaction, i, r, 0, i});
    for (int s = 0; s < static_cast<int>(state.species); ++s) {
      const int g = voxels.graph_of_species[s];
      if (g < 0 || !network_.stochastic(s)) continue;
      const JumpGraph& graph = voxels.graphs[g];
      for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
        const double rate = jump_rate(graph, p, network_.diffusivity(s), voxels.volume[i]);
        channels_.push_back({Kind::jump, i, s, rate, graph.target[p]});
      }
    }
  }
  for (const Exchange& exchange : voxels.exchanges) {
    const int species = static_cast<int>(exchange.species);
    if (!network_.stochastic(species)) continue;
    channels_.push_back({Kind::exit, exchange.voxel, species, exchange.exit_rate, exchange.voxel});
    channels_.push_back({Kind::entry, exchange.voxel, species, exchange.entry_rate, exchange.voxel});
  }
  std::ranges::stable_sort(channels_, {}, &Channel::voxel);
  first_.assign(voxels.size() + 1, 0);
  for (const Channel& channel : channels_) ++first_[channel.voxel + 1];
  for (std::size_t i = 0; i < voxels.size(); ++i) first_[i + 1] += first_[i];
}

double Direct::propensity(const Channel& channel) {
  if (channel.kind == Kind::reaction) return propensities_(channel.index, channel.voxel);
  if (channel.kind == Kind::entry) return channel.rate;
  return channel.rate * static_cast<double>(state_->count[channel.voxel * state_->species + channel.index]);
}

void Direct::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  base::RandomSequence random(key, base::Stream::stochastic_exact, step);
  process_ = process;
  value_.assign(channels_.size(), 0.0);
  total_.assign(first_.size() - 1, 0.0);
  for (const Window& window : propensities_.windows(t, dt)) {
    propensities_.set_window(window);
    for (std::size_t i = 0; i < total_.size(); ++i) refresh(i);
    if (!pass(window, network_.sampled_rates_change_in_time() ? 0.0 : t, random)) return;
  }
}

void Direct::refresh(std::size_t voxel) {
  total_[voxel] = 0;
  for (std::size_t c = first_[voxel]; c < first_[voxel + 1]; ++c) {
    const bool reaction = channels_[c].kind == Kind::reaction;
    if (process_ != (reaction ? Process::diffusion : Process::reactions)) value_[c] = propensity(channels_[c]);
    total_[voxel] += value_[c];
  }
}

// The voxel, and those that see it across a surface.
void Direct::refresh_around(std::size_t voxel) {
  refresh(voxel);
  for (const std::uint32_t beside : beside_.of(voxel)) refresh(beside);
}

// All events of a window whose times count from `origin`; false where the watch stops it.
bool Direct::pass(const Window& window, double origin, base::RandomSequence& random) {
  const std::size_t voxels = total_.size();
  for (double t = window.from;;) {
    double sum = 0;
    for (double one : total_) sum += one;
    if (sum <= 0 || (t += random.exponential() / sum) > window.to) return true;
    double rest = random.uniform() * sum;
    std::size_t voxel = 0;
    while (voxel + 1 < voxels && rest >= total_[voxel]) rest -= total_[voxel++];
    std::size_t c = first_[voxel];
    while (c + 1 < first_[voxel + 1] && rest >= value_[c]) rest -= value_[c++];
    // Round-off at the end of a sum may point at a channel that cannot fire.
    if (c == first_[voxel + 1] || value_[c] <= 0) continue;
    Channel& channel = channels_[c];
    if (channel.kind == Kind::reaction) {
      if (!propensities_.happens(channel.index, voxel, t, rest, value_[c])) continue;
      channel.target = static_cast<std::uint32_t>(propensities_.partner(channel.index, voxel, rest));
    }
    fire(channel);
    refresh_around(channel.voxel);
    if (channel.target != channel.voxel) refresh_around(channel.target);
    if (watch_ && channel.kind == Kind::reaction && watch_->stops(origin + t)) return false;
  }
}

void Direct::fire(const Channel& channel) {
  const std::size_t at = channel.voxel * state_->species + channel.index;
  switch (channel.kind) {
    case Kind::reaction:
      change_numbers(*state_, network_, network_.reactions()[channel.index], channel.voxel, channel.target);
      book_reaction(state_->ledger, network_, network_.reactions()[channel.index], 1);
      ++state_->reaction_events;
      break;
    case Kind::jump:
      --state_->count[at];
      ++state_->count[channel.target * state_->species + channel.index];
      ++state_->jump_events;
      break;
    case Kind::exit:
      --state_->count[at];
      ++state_->ledger.counts[channel.index].left;
      break;
    case Kind::entry:
      ++state_->count[at];
      ++state_->ledger.counts[channel.index].entered;
      break;
  }
}

}  // namespace shmoo::rdme
