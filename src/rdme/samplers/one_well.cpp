#include "rdme/samplers/one_well.hpp"

#include "rdme/jump_table.hpp"
#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {

OneWell::OneWell(const Network& network)
    : network_(network),
      propensities_(network),
      running_(network.sampled_in(0).size()),
      value_(network.reactions().size(), 0.0),
      events_(network.reactions().size(), 0) {}

std::shared_ptr<const JumpTables> OneWell::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::jumps);
}

void OneWell::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables>) {
  state_ = &state;
  propensities_.bind(voxels, state);
  flatten();
  derived_ = false;
}

void OneWell::flatten() {
  first_.assign(1, 0);
  changes_.clear();
  for (const Reaction& reaction : network_.reactions()) {
    for (const auto& change : reaction.changes) {
      const auto s = static_cast<std::size_t>(change.species);
      const bool whole = network_.stochastic(change.species);
      changes_.push_back({whole ? &state_->count[s] : nullptr, whole ? nullptr : &state_->amount[s], change.amount});
    }
    first_.push_back(changes_.size());
  }
}

void OneWell::derive_all() {
  if (running_ > few) groups_.clear(value_.size());
  for (const int r : network_.sampled_in(0)) refresh(r);
  derived_ = true;
}

void OneWell::refresh(int reaction) {
  const double now = propensities_(reaction, 0);
  value_[static_cast<std::size_t>(reaction)] = now;
  if (running_ > few) groups_.set(static_cast<std::uint32_t>(reaction), now);
}

void OneWell::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  if (process == Process::diffusion || running_ == 0) return;
  AttemptSequence sequence(key, base::Stream::stochastic_exact, step);
  for (const Window& window : propensities_.windows(t, dt)) {
    propensities_.set_window(window);
    if (!derived_ || network_.sampled_rates_change_in_time()) derive_all();
    if (!pass(window, network_.sampled_rates_change_in_time() ? 0.0 : t, sequence)) break;
  }
  close_books(*state_, network_, events_);
}

double OneWell::sum() const {
  if (running_ > few) return groups_.sum();
  double sum = 0;
  for (const int r : network_.sampled_in(0)) sum += value_[static_cast<std::size_t>(r)];
  return sum;
}

// The reaction at which a uniform number points, or -1 where it points at none; `rest` is what is left of it.
int OneWell::choose(double uniform, double& rest) const {
  if (running_ > few) {
    const Groups::Pick pick = groups_.pick(uniform);
    rest = pick.rest;
    return rest < groups_.total(pick.member) ? static_cast<int>(pick.member) : -1;
  }
  rest = uniform * sum();
  for (const int r : network_.sampled_in(0)) {
    const double here = value_[static_cast<std::size_t>(r)];
    if (rest < here) return r;
    rest -= here;
  }
  return -1;
}

// All events of a window whose times count from `origin`; false where the watch stops it.
bool OneWell::pass(const Window& window, double origin, AttemptSequence& sequence) {
  Attempts attempts;
  std::size_t next = Attempts::size;
  for (double left = window.to - window.from;;) {
    const double all = sum();
    if (!(all > 0)) return true;
    if (next == Attempts::size) {
      sequence.next(attempts);
      next = 0;
    }
    const std::size_t k = next++;
    if ((left -= attempts.wait[k] / all) <= 0) return true;
    double rest = 0;
    const int reaction = choose(attempts.choice[k], rest);
    if (reaction < 0) continue;
    if (!propensities_.happens(reaction, 0, window.to - left, rest, value_[static_cast<std::size_t>(reaction)]))
      continue;
    fire(reaction);
    if (watch_ && watch_->stops(origin + window.to - left)) return false;
  }
}

void OneWell::fire(int reaction) {
  const auto r = static_cast<std::size_t>(reaction);
  for (std::size_t c = first_[r]; c < first_[r + 1]; ++c) {
    if (changes_[c].count)
      *changes_[c].count += changes_[c].by;
    else
      *changes_[c].amount += static_cast<double>(changes_[c].by);
  }
  ++events_[r];
  for (const int other : network_.after_reaction(reaction, 0)) refresh(other);
}

}  // namespace shmoo::rdme
