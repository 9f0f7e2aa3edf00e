#include "rdme/event_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "rdme/time/steps_of.hpp"

namespace shmoo::rdme {
namespace {

constexpr int most_at_once = 100000;  // events at one moment
constexpr double rounding = 1e-6;     // relative, by which a number of molecules may fail to be whole
constexpr double most_molecules = 0x1p53;
constexpr double never = std::numeric_limits<double>::infinity();

std::unique_ptr<Expression> compile(const std::string& text, const ExpressionNames& names) {
  return text.empty() ? nullptr : std::make_unique<Expression>(text, names);
}

}  // namespace

EventClock::EventClock(const scene::Scene& scene, const Network& network) : network_(network) {
  smooth_ = std::ranges::none_of(
      scene.species, [](const scene::Species& one) { return one.method == scene::SpeciesMethod::stochastic; });
  std::vector<base::Diagnostic> mistakes;
  for (const scene::Event& event : scene.events) {
    try {
      add(event, scene);
    } catch (const base::InputError& error) {
      for (const base::Diagnostic& one : error.diagnostics())
        mistakes.push_back({event.where, fmt::format("event {}: {}", event.name, one.message)});
    }
  }
  if (!mistakes.empty()) throw base::InputError(std::move(mistakes));
}

void EventClock::add(const scene::Event& from, const scene::Scene& scene) {
  const ExpressionNames names = expression_names(network_);
  Event event{from.name,
              compile(from.trigger, names),
              compile(from.delay, names),
              compile(from.priority, names),
              TimedRate(from.trigger, names),
              {},
              from.initially,
              from.persistent,
              from.values_at_trigger};
  event.reads_time = event.trigger->reads_time();
  event.reads_amounts = !event.trigger->reads().empty();
  for (const scene::Assignment& one : from.assignments) {
    Target target{-1, -1, Expression(one.expression, names)};
    for (std::size_t s = 0; s < scene.species.size(); ++s)
      if (scene.species[s].name == one.target) target.species = static_cast<int>(s);
    for (std::size_t v = 0; v < network_.varying().size(); ++v)
      if (network_.parameters()[static_cast<std::size_t>(network_.varying()[v])].first == one.target)
        target.parameter = static_cast<int>(v);
    event.targets.push_back(std::move(target));
  }
  for (const int s : event.trigger->reads()) {
    if (smooth_ || network_.stochastic(s)) continue;
    throw base::InputError(
        fmt::format("its trigger reads {}, which is deterministic beside sampled species, and moves between looks; "
                    "give it method = "
                    "\"stochastic\", or make all species deterministic",
                    network_.name(s)));
  }
  if (smooth_ && event.reads_amounts)
    for (const StepSource& step : steps_of(from.trigger))
      if (Expression root(step.distance, names); !root.reads().empty()) roots_.push_back(std::move(root));
  reads_amounts_ |= event.reads_amounts;
  any_mixed_ |= event.reads_amounts && event.reads_time;
  events_.push_back(std::move(event));
}

void EventClock::begin(State& state) {
  state_ = &state;
  waiting_.clear();
  for (Event& event : events_) event.holds = event.initially;
}

double EventClock::value(Expression& formula, double t) { return value_at(formula, network_, *state_, t); }

double EventClock::next(double t, double end) {
  double first = never;
  for (const Waiting& one : waiting_) first = std::min(first, one.due);
  for (Event& event : events_)
    if (event.reads_time) first = std::min(first, first_turn(event, t, end));
  return first;
}

// Steps of the trigger's comparisons are where it may turn; whether it does is seen there.
double EventClock::first_turn(Event& event, double t, double end) {
  event.turns.prepare([&](Expression& formula) { value(formula, t); });
  std::vector<double> moments;
  event.turns.common_steps(t, end, moments);
  const bool integrated = smooth_ && event.reads_amounts;  // then amounts are not known yet, and roots are watched
  if (!integrated) event.turns.local_steps(t, end, moments);
  std::ranges::sort(moments);
  for (const double moment : moments)
    if (moment > t && (integrated || holds(event, moment) != event.holds)) return moment;
  return never;
}

bool EventClock::stops(double t) {
  const auto turned = [&](Event& event) { return event.reads_amounts && holds(event, t) != event.holds; };
  if (!any_mixed_ && std::ranges::none_of(events_, turned)) return false;
  stopped_ = std::min(stopped_, t);
  return true;
}

void EventClock::distances(double t, const State& state, double* values) {
  for (Expression& root : roots_) *values++ = value_at(root, network_, state, t);
}

bool EventClock::at_a_root(double t) {
  return std::ranges::any_of(roots_, [&](Expression& root) { return value(root, t) == 0.0; });
}

std::vector<double> EventClock::values(Event& event, double t) {
  std::vector<double> all;
  for (Target& target : event.targets) all.push_back(value(target.value, t));
  return all;
}

void EventClock::look(double t) {
  for (std::size_t e = 0; e < events_.size(); ++e) {
    Event& event = events_[e];
    const bool now = holds(event, t);
    if (now && !event.holds) {
      const double delay = event.delay ? value(*event.delay, t) : 0.0;
      if (!(delay >= 0.0))
        throw base::RunError(
            fmt::format("event {} has the delay {} s at t = {} s; it must not be negative", event.name, delay, t));
      waiting_.push_back({e, t + delay, event.values_at_trigger ? values(event, t) : std::vector<double>{}});
    }
    if (!now && event.holds && !event.persistent)
      std::erase_if(waiting_, [&](const Waiting& one) { return one.event == e; });
    event.holds = now;
  }
}

bool EventClock::act(double t) {
  look(t);
  int made = 0;
  while (make_one(t)) {
    if (++made > most_at_once)
      throw base::RunError(
          fmt::format("more than {} events at t = {} s: they set one another off without end", most_at_once, t));
    look(t);
  }
  return made > 0;
}

// Of what is due the event of the highest priority; of equals the one that comes first in the file.
bool EventClock::make_one(double t) {
  const auto priority = [&](const Waiting& one) {
    const auto& formula = events_[one.event].priority;
    return formula ? value(*formula, t) : 0.0;
  };
  std::size_t best = waiting_.size();
  for (std::size_t w = 0; w < waiting_.size(); ++w) {
    if (waiting_[w].due > t) continue;
    const bool first = best == waiting_.size();
    const double gain = first ? 1.0 : priority(waiting_[w]) - priority(waiting_[best]);
    if (gain > 0.0 || (gain == 0.0 && waiting_[w].event < waiting_[best].event)) best = w;
  }
  if (best == waiting_.size()) return false;
  Waiting now = std::move(waiting_[best]);
  waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(best));
  Event& event = events_[now.event];
  if (!event.values_at_trigger) now.values = values(event, t);
  for (std::size_t k = 0; k < event.targets.size(); ++k) set(event, event.targets[k], now.values[k], t);
  return true;
}

void EventClock::set(const Event& event, const Target& target, double value, double t) {
  if (target.species < 0) {
    if (!std::isfinite(value))
      throw base::RunError(
          fmt::format("event {} sets a parameter to {} at t = {} s, which is no finite number", event.name, value, t));
    state_->parameter[static_cast<std::size_t>(target.parameter)] = value;
    return;
  }
  const auto s = static_cast<std::size_t>(target.species);
  const auto refuse = [&](const char* why) {
    throw base::RunError(fmt::format("event {} sets {} to {} molecules at t = {} s; {}", event.name,
                                     network_.name(target.species), value, t, why));
  };
  if (!(value >= 0.0 && value < most_molecules)) refuse("it must be >= 0 and below 2^53");
  const auto book = [](auto& account, auto change) {
    (change > 0 ? account.created : account.destroyed) += std::abs(change);
  };
  if (!network_.stochastic(target.species)) {
    book(state_->ledger.amounts[s], value - state_->amount[s]);
    state_->amount[s] = value;
    return;
  }
  const double whole = std::rint(value);
  if (std::abs(value - whole) > rounding * std::max(1.0, whole))
    refuse("a stochastic species has whole ones; write rint(...) round the formula, or make it deterministic");
  book(state_->ledger.counts[s], static_cast<std::int64_t>(whole) - state_->count[s]);
  state_->count[s] = static_cast<std::int64_t>(whole);
}

}  // namespace shmoo::rdme
