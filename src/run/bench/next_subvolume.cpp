#include "run/bench/next_subvolume.hpp"

#include <limits>
#include <utility>

namespace shmoo::run::bench {

NextSubvolume::NextSubvolume(const rdme::Network& network, const rdme::Voxels& voxels, rdme::State& state)
    : network_(network), voxels_(voxels), state_(state), random_({1, 0}, base::Stream::stochastic_exact) {
  const std::size_t n = voxels.size();
  const auto& graph = voxels.graphs[0];
  jump_weight_.assign(n, 0.0);
  rate_.resize(n);
  reactions_.resize(n);
  time_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p) jump_weight_[i] += graph.coupling[p];
    heap_.push_back(std::uint32_t(i));
    place_.push_back(std::uint32_t(i));
    redraw(i);
  }
  for (std::size_t place = n; place-- > 0;) sift(place);
}

double NextSubvolume::reaction_rate(int reaction, std::size_t voxel) const {
  const auto& law = network_.reactions()[std::size_t(reaction)];
  double rate = law.rate_constant;  // voxels have unit volume
  for (const auto& term : law.reactants) {
    for (int k = 0; k < term.count; ++k)
      rate *= double(state_.count[voxel * state_.species + std::size_t(term.species)] - k);
  }
  return rate;
}

double NextSubvolume::total_rate(std::size_t voxel) const {
  double rate = 0.0;
  for (std::size_t s = 0; s < state_.species; ++s)
    rate += double(state_.count[voxel * state_.species + s]) * network_.diffusivity(int(s)) * jump_weight_[voxel];
  return rate;
}

void NextSubvolume::redraw(std::size_t voxel) {
  reactions_[voxel] = 0.0;
  for (std::size_t r = 0; r < network_.reactions().size(); ++r) reactions_[voxel] += reaction_rate(int(r), voxel);
  rate_[voxel] = reactions_[voxel] + total_rate(voxel);
  time_[voxel] =
      rate_[voxel] > 0.0 ? now_ + random_.exponential() / rate_[voxel] : std::numeric_limits<double>::infinity();
}

// What is left of a waiting time stretches with the rate (Gibson & Bruck).
void NextSubvolume::rescale(std::size_t voxel) {
  const double before = rate_[voxel], left = time_[voxel] - now_;
  if (before == 0.0) return redraw(voxel);
  reactions_[voxel] = 0.0;
  for (std::size_t r = 0; r < network_.reactions().size(); ++r) reactions_[voxel] += reaction_rate(int(r), voxel);
  rate_[voxel] = reactions_[voxel] + total_rate(voxel);
  time_[voxel] = rate_[voxel] > 0.0 ? now_ + left * before / rate_[voxel] : std::numeric_limits<double>::infinity();
}

void NextSubvolume::events(std::uint64_t number) {
  for (std::uint64_t k = 0; k < number; ++k) {
    const std::size_t voxel = heap_[0];
    now_ = time_[voxel];
    const std::size_t other = fire(voxel);
    redraw(voxel);
    sift(place_[voxel]);
    if (other == voxel) continue;
    rescale(other);
    sift(place_[other]);
  }
}

std::size_t NextSubvolume::fire(std::size_t voxel) {
  const double at = random_.uniform() * rate_[voxel];
  if (at < reactions_[voxel]) {
    react(voxel, at);
    return voxel;
  }
  return jump(voxel, at - reactions_[voxel]);
}

void NextSubvolume::react(std::size_t voxel, double at) {
  std::size_t reaction = 0;
  for (; reaction + 1 < network_.reactions().size(); ++reaction) {
    at -= reaction_rate(int(reaction), voxel);
    if (at < 0.0) break;
  }
  for (const auto& change : network_.reactions()[reaction].changes)
    state_.count[voxel * state_.species + std::size_t(change.species)] += change.amount;
  ++state_.reaction_events;
}

std::size_t NextSubvolume::jump(std::size_t voxel, double at) {
  const auto& graph = voxels_.graphs[0];
  std::size_t s = 0;
  for (; s + 1 < state_.species; ++s) {
    const double rate =
        double(state_.count[voxel * state_.species + s]) * network_.diffusivity(int(s)) * jump_weight_[voxel];
    if (at < rate) break;
    at -= rate;
  }
  at /= double(state_.count[voxel * state_.species + s]) * network_.diffusivity(int(s));
  auto p = graph.first[voxel];
  for (; p + 1 < graph.first[voxel + 1]; ++p) {
    at -= graph.coupling[p];
    if (at < 0.0) break;
  }
  const std::size_t to = graph.target[p];
  --state_.count[voxel * state_.species + s];
  ++state_.count[to * state_.species + s];
  ++state_.jump_events;
  return to;
}

void NextSubvolume::swap(std::size_t a, std::size_t b) {
  std::swap(heap_[a], heap_[b]);
  place_[heap_[a]] = std::uint32_t(a);
  place_[heap_[b]] = std::uint32_t(b);
}

// Up while earlier than the parent, then down while later than a child.
void NextSubvolume::sift(std::size_t place) {
  const auto time = [this](std::size_t at) { return time_[heap_[at]]; };
  while (place > 0 && time(place) < time((place - 1) / 2)) {
    swap(place, (place - 1) / 2);
    place = (place - 1) / 2;
  }
  for (;;) {
    std::size_t child = 2 * place + 1;
    if (child >= heap_.size()) return;
    if (child + 1 < heap_.size() && time(child + 1) < time(child)) ++child;
    if (time(place) <= time(child)) return;
    swap(place, child);
    place = child;
  }
}

}  // namespace shmoo::run::bench
