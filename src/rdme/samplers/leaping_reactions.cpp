#include "rdme/samplers/leaping_reactions.hpp"

#include <algorithm>
#include <limits>

namespace shmoo::rdme {
namespace {

constexpr int exact_run = 100;  // events before another look at leaps
constexpr double events_per_poisson_number =
    8;  // a leap pays beyond: what two stages of a reaction cost, in exact events

}  // namespace

LeapingReactions::LeapingReactions(const Network& network, double tolerance)
    : network_(network),
      propensities_(network),
      condition_(network, tolerance),
      rate_(network.reactions().size(), 0.0),
      first_(network.reactions().size(), 0),
      second_(network.reactions().size(), 0),
      events_(network.reactions().size(), 0) {}

void LeapingReactions::bind(const Voxels& voxels, State& state) {
  voxels_ = &voxels;
  state_ = &state;
  propensities_.bind(voxels, state);
}

void LeapingReactions::advance(std::uint32_t voxel, const Window& window, base::RandomSequence& random) {
  const std::span<const int> running = network_.sampled_in(voxels_->material[voxel]);
  if (running.data() != running_.data()) rows_.clear(1, network_.reactions().size());
  running_ = running;
  end_ = window.to;
  propensities_.set_window(window);
  derive(voxel);
  for (double left = window.to - window.from; left > 0 && rows_.total(0) > 0;) {
    double longest = 0;
    if (rows_.total(0) * left > worth()) {
      choose_leaping(voxel);
      longest = std::min(left, condition_.longest(leaping_, rate_, *state_, voxel));
    }
    if (longest * (rows_.total(0) - waiting_rate_) > worth()) {
      const double length = leap(voxel, longest, left, random);
      left = length < left ? left - length : 0.0;
      derive(voxel);
    } else {
      left = exact_events(voxel, left, random);
    }
  }
}

double LeapingReactions::worth() const { return events_per_poisson_number * static_cast<double>(running_.size()); }

void LeapingReactions::derive(std::uint32_t voxel) {
  for (const int r : running_) rows_.set(0, std::size_t(r), propensities_(r, voxel));
}

// Up to a hundred events; what is left of the time.
double LeapingReactions::exact_events(std::uint32_t voxel, double left, base::RandomSequence& random) {
  for (int events = 0; events < exact_run; ++events) {
    const double total = rows_.total(0);
    if (total <= 0 || (left -= random.exponential() / total) <= 0) return 0;
    double rest = random.uniform() * total;
    const std::size_t picked = rows_.pick(0, rest);
    if (picked == rate_.size()) continue;  // round-off at the end of a sum
    const int reaction = static_cast<int>(picked);
    if (!propensities_.happens(reaction, voxel, end_ - left, rest, rows_.value(0, picked))) continue;
    fire(voxel, reaction);
    for (const int r : network_.after_reaction(reaction, voxels_->material[voxel])) {
      rows_.set(0, std::size_t(r), propensities_(r, voxel));
    }
  }
  return left;
}

void LeapingReactions::fire(std::uint32_t voxel, int reaction) {
  change_numbers(*state_, network_, network_.reactions()[reaction], voxel);
  ++events_[reaction];
}

void LeapingReactions::choose_leaping(std::uint32_t voxel) {
  leaping_.clear();
  waiting_.clear();
  waiting_rate_ = 0;
  for (const int r : running_) {
    rate_[r] = rows_.value(0, std::size_t(r));
    if (network_.reactions()[r].reads_time || condition_.critical(r, *state_, voxel)) {
      waiting_.push_back(r);
      waiting_rate_ += rate_[r];
    } else {
      leaping_.push_back(r);
    }
  }
}

// Returns its length [s]: the longest, or until the next event of a reaction that does not leap.
double LeapingReactions::leap(std::uint32_t voxel, double longest, double left, base::RandomSequence& random) {
  const double wait =
      waiting_rate_ > 0 ? random.exponential() / waiting_rate_ : std::numeric_limits<double>::infinity();
  double h = std::min(longest, wait);
  while (!try_leap(voxel, h, random)) h *= 0.5;
  if (h == wait) fire_thinned(voxel, pick_waiting(random), end_ - left + h, random);
  return h;
}

int LeapingReactions::pick_waiting(base::RandomSequence& random) const {
  double rest = random.uniform() * waiting_rate_;
  int picked = -1;
  for (const int r : waiting_) {
    if (rate_[r] <= 0) continue;
    picked = r;
    if ((rest -= rate_[r]) < 0) break;
  }
  return picked;
}

// After a leap, which may have used up what the reaction needs, and at a rate that may contain t.
void LeapingReactions::fire_thinned(std::uint32_t voxel, int reaction, double t, base::RandomSequence& random) {
  const double bound = propensities_(reaction, voxel);
  if (bound > 0 && propensities_.happens(reaction, voxel, t, random.uniform() * bound, bound)) fire(voxel, reaction);
}

bool LeapingReactions::try_leap(std::uint32_t voxel, double h, base::RandomSequence& random) {
  for (const int r : leaping_) first_[r] = base::poisson(random, 0.5 * h * rate_[r]);
  add(voxel, first_, 1);
  bool enough = nothing_negative(voxel);
  for (const int r : leaping_) {
    const double slope = enough ? 2 * propensities_(r, voxel) - rate_[r] : 0.0;
    second_[r] = slope > 0 ? base::poisson(random, 0.5 * h * slope) : 0;
  }
  add(voxel, second_, 1);
  enough = enough && nothing_negative(voxel);
  if (!enough) {
    add(voxel, first_, -1);
    add(voxel, second_, -1);
    return false;
  }
  for (const int r : leaping_) events_[r] += first_[r] + second_[r];
  return true;
}

void LeapingReactions::add(std::uint32_t voxel, std::span<const std::int64_t> times, std::int64_t sign) {
  for (const int r : leaping_) {
    for (const Change& change : network_.reactions()[r].changes) {
      const std::size_t at = voxel * state_->species + change.species;
      const std::int64_t molecules = sign * times[r] * change.amount;
      if (network_.stochastic(change.species)) {
        state_->count[at] += molecules;
      } else {
        state_->amount[at] += static_cast<double>(molecules);
      }
    }
  }
}

// Of what leaping reactions take.
bool LeapingReactions::nothing_negative(std::uint32_t voxel) const {
  for (const int r : leaping_) {
    for (const Change& change : network_.reactions()[r].changes) {
      const std::size_t at = voxel * state_->species + change.species;
      if (change.amount > 0) continue;
      if (network_.stochastic(change.species) ? state_->count[at] < 0 : state_->amount[at] < 0) return false;
    }
  }
  return true;
}

}  // namespace shmoo::rdme
