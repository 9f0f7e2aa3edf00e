#include "coupling/well.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "coupling/schedule.hpp"
#include "rdme/initial.hpp"
#include "scene/well.hpp"

namespace shmoo::coupling {
namespace {

constexpr double soon = 1e-9;  // of what is left to the next record

rdme::Voxels one_voxel(std::size_t species) {
  rdme::Voxels voxels;
  voxels.volume = {1.0};
  voxels.material = {0};
  voxels.position = {{0.0, 0.0, 0.0}};
  voxels.graph_of_species.assign(species, -1);
  return voxels;
}

bool any(const scene::Scene& scene, scene::SpeciesMethod method) {
  return std::any_of(scene.species.begin(), scene.species.end(),
                     [&](const scene::Species& one) { return one.method == method; });
}

// Whether rounding leaves the start to chance.
bool starts_alike(const scene::Scene& scene) {
  return std::all_of(scene.initials.begin(), scene.initials.end(), [&](const scene::Initial& one) {
    const auto& [value, expression] = one.concentration;
    return one.count || (expression.empty() && value == std::floor(value)) ||
           scene.species[std::size_t(one.species)].method != scene::SpeciesMethod::stochastic;
  });
}

}  // namespace

WellPlan::WellPlan(const scene::Scene& as_said, const std::vector<double>& reference)
    : scene(scene::in_numbers(as_said)),
      network(scene),
      voxels(one_voxel(scene.species.size())),
      step(splitting_step(scene, network, reference)),
      records(as_said, network, record_times(scene.run), !random()) {
  if (starts_alike(scene)) same_start_ = std::make_unique<rdme::State>(start({scene.run.seed, 0}));
}

bool WellPlan::random() const {
  return any(scene, scene::SpeciesMethod::stochastic) || any(scene, scene::SpeciesMethod::langevin);
}

rdme::State WellPlan::start(const base::RandomKey& key) const {
  return same_start_ ? *same_start_ : rdme::initial_state(scene, network, voxels, key);
}

Well::Well(const WellPlan& plan) : plan_(plan), reader_(plan.records), events_(plan.scene, plan.network) {
  if (any(plan.scene, scene::SpeciesMethod::stochastic)) {
    const auto& numerics = plan.scene.numerics;
    sampler_ = numerics.sampler == scene::Sampler::composition_rejection
                   ? rdme::make_well_sampler(numerics.sampler, plan.network)
                   : rdme::make_sampler(numerics, plan.network);
    tables_ = sampler_->prepare(plan.voxels);
    if (events_.reads_amounts()) sampler_->watch(&events_);
  }
  if (any(plan.scene, scene::SpeciesMethod::langevin)) add_langevin();
  if (any(plan.scene, scene::SpeciesMethod::deterministic))
    solver_ = std::make_unique<rdme::DeterministicSolver>(plan.network, plan.scene.numerics.tolerance);
  if (solver_ && events_.roots() > 0) solver_->watch(&events_);
}

void Well::add_langevin() {
  if (events_.reads_amounts()) {
    throw base::InputError(
        "events that depend on amounts need species whose numbers are followed event by event or by an integrator; set "
        "the method of all \"langevin\" species to \"stochastic\" or \"deterministic\"");
  }
  langevin_ = std::make_unique<rdme::LangevinSolver>(plan_.network, plan_.scene.numerics.leap_tolerance);
}

bool Well::realise(const base::RandomKey& key, RecordSink& sink, const Progress& progress, Outcome& outcome) {
  key_ = key;
  state_ = plan_.start(key);
  time_ = 0.0;
  steps_ = 0;
  if (sampler_) sampler_->bind(plan_.voxels, state_, tables_);
  if (solver_) solver_->bind(plan_.voxels, state_);
  if (langevin_) langevin_->bind(plan_.voxels, state_);
  events_.begin(state_);
  look_soon_ = events_.at_a_root(time_);
  act();
  const auto& times = plan_.records.layout().times;
  reader_.read(0, state_, sink);
  for (std::size_t record = 1; record < times.size(); ++record) {
    if (progress.stop && progress.stop()) return false;
    advance_to(times[record]);
    reader_.read(record, state_, sink);
    if (progress.report) progress.report(times[record] / times.back());
  }
  outcome.ledger = state_.ledger;
  outcome.balanced = rdme::imbalance(state_, plan_.network).empty();
  outcome.reaction_events = state_.reaction_events;
  outcome.jump_events = 0;
  return true;
}

void Well::act() {
  if (!events_.any() || !events_.act(time_)) return;
  if (sampler_) sampler_->amounts_changed();
  if (solver_) solver_->parameters_changed();
  look_soon_ = events_.at_a_root(time_);
}

void Well::advance_to(double target) {
  while (time_ < target) {
    double end = interval_end(time_, plan_.step.value, target);
    if (events_.any()) end = std::min(end, events_.next(time_, end));
    if (std::exchange(look_soon_, false)) end = time_ + soon * (end - time_);
    advance(end);
    act();
  }
}

// Up to `end`, or to where an event's trigger turns before. Lie or Strang, as in Chemistry; where a trigger may stop
// the sampler the smooth amounts follow it (Lie), as it is not known before how far it goes.
void Well::advance(double end) {
  const double start = time_, dt = end - start;
  const bool both = (sampler_ || langevin_) && (solver_ || (sampler_ && langevin_)),
             stoppable = both && events_.reads_amounts();
  const bool strang = both && !stoppable && plan_.scene.numerics.splitting == scene::Splitting::strang;
  const double before = stoppable ? 0.0 : strang ? 0.5 * dt : dt;
  time_ = end;
  if (solver_ && before > 0.0) {
    const double reached = solver_->advance(start, before, rdme::Process::both);
    if (!both && reached < end) {
      time_ = reached;
      look_soon_ = events_.at_a_root(time_);
    }
  }
  if (langevin_) langevin_->advance(start, before, rdme::Process::both, key_, 2 * steps_);
  if (sampler_) advance_sampler(start, dt, end);
  if (langevin_ && strang) langevin_->advance(start + before, dt - before, rdme::Process::both, key_, 2 * steps_ + 1);
  ++steps_;
  if (solver_ && (strang || stoppable)) solver_->advance(start + before, time_ - start - before, rdme::Process::both);
}

void Well::advance_sampler(double start, double dt, double end) {
  if (solver_ || langevin_) sampler_->amounts_changed();
  events_.go_on(end);
  sampler_->advance(start, dt, rdme::Process::both, key_, steps_);
  time_ = events_.stopped();
}

}  // namespace shmoo::coupling
