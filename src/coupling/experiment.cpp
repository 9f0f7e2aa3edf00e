#include "coupling/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/activity.hpp"
#include "coupling/chemistry.hpp"
#include "coupling/quasi_static/quasi_static.hpp"
#include "coupling/recorder.hpp"
#include "coupling/rules/judgement.hpp"
#include "coupling/schedule.hpp"
#include "coupling/timeline.hpp"
#include "coupling/well_mixed.hpp"
#include "scene/motion.hpp"
#include "scene/well.hpp"

namespace shmoo::coupling {
namespace {

template <int D>
std::vector<base::Vec<D>> voxel_positions(const sph::Filling<D>& filling) {
  std::vector<base::Vec<D>> places(filling.particles.position.values().begin(),
                                   filling.particles.position.values().begin() + long(filling.voxels));
  places.resize(filling.voxels + filling.reserve, filling.box.lower);
  return places;
}

template <int D>
std::array<std::size_t, 3> lattice_cells(const sph::Filling<D>& filling) {
  std::array<std::size_t, 3> cells{1, 1, 1};
  for (int a = 0; a < D; ++a)
    cells[std::size_t(a)] = std::size_t(std::lround(filling.box.size()[a] / filling.spacing[a]));
  return cells;
}

template <int D>
class ExperimentOf final : public Experiment {
 public:
  explicit ExperimentOf(Judgement judgement)
      : ExperimentOf(std::make_unique<scene::Scene>(std::move(judgement.scene)), judgement.reference) {
    for (auto& number : judgement.derived) derived_.push_back(std::move(number));
    notes_ = std::move(judgement.notes);
  }

  const scene::Scene& scene() const override { return *scene_; }
  const RecordLayout& layout() const override { return recorder_.layout(); }
  std::size_t particles() const override { return filling_.voxels + filling_.reserve; }
  std::vector<std::int32_t> material_of_particle() const override {
    return {geometry_.material().begin(), geometry_.material().end()};
  }
  std::vector<std::array<double, 3>> start_position() const override {
    std::vector<std::array<double, 3>> places(filling_.voxels, std::array<double, 3>{});
    for (std::size_t i = 0; i < places.size(); ++i)
      for (int a = 0; a < D; ++a) places[i][std::size_t(a)] = filling_.particles.position[i][a];
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    places.resize(particles(), {nowhere, nowhere, nowhere});
    return places;
  }
  std::vector<Derived> derived() const override { return derived_; }
  std::vector<std::string> notes() const override { return notes_; }

  bool prepare(RecordSink& sink, const Progress& progress) override {
    if (!own_flow_) {
      auto timeline = make_timeline({scene_->run.seed, 0});
      start_ = timeline->start();
      if (timeline->start_picture()) recorder_.flow(0, *timeline->start_picture(), sink);
      if (start_) recorder_.volume(0, start_->frame(), sink);
      const bool finished = timeline->run([&](const Interval<D>& interval) {
        if (progress.stop && progress.stop()) return false;
        if (interval.record >= 0) record_flow(interval, sink);
        if (progress.report) progress.report(interval.end / scene_->run.until);
        if (has_chemistry_) intervals_.push_back(interval);
        return true;
      });
      if (!finished) return false;
      derive(*timeline);
    }
    return random() ? true : tell(0, sink, progress, alike_);
  }

  std::vector<double> activity(const std::function<bool()>& stop) const override {
    if (scene::in_motion(*scene_) || !has_chemistry_ || !random() || !start_) return {};
    std::array<double, 3> period{};
    for (int a = 0; a < D; ++a) period[std::size_t(a)] = filling_.box.periodic[a] ? filling_.box.size()[a] : 0.0;
    return foretell_activity(*scene_, start_->ground()->voxels, period, stop);
  }

  bool realise(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome) override {
    if (random()) return tell(k, sink, progress, outcome);
    outcome = alike_;
    return true;
  }

 private:
  ExperimentOf(std::unique_ptr<scene::Scene> scene, const std::vector<double>& reference)
      : scene_(std::move(scene)),
        network_(*scene_),
        filling_(sph::fill<D>(*scene_)),
        geometry_(*scene_, filling_),
        stages_(geometry_, *scene_, network_),
        has_chemistry_(network_.species() > 0),
        flow_random_(scene_->effects.flow && scene_->effects.thermal_noise),
        own_flow_(flow_random_ || scene::acts_back(*scene_)),
        step_(splitting_step(*scene_, network_, reference)),
        recorder_(*scene_, network_, geometry_, lattice_cells(filling_), record_times(scene_->run), !random(),
                  !(own_flow_ && random())) {
    if (has_chemistry_) derived_.push_back({"splitting_step", step_.value, "s", step_.why});
    if (has_chemistry_ && step_.error > 0.0) derived_.push_back(splitting_error(step_));
    if (scene::in_motion(*scene_)) {
      for (auto& number : make_live_flow<D>(*scene_, {scene_->run.seed, 0})->derived())
        derived_.push_back(std::move(number));
    }
  }

  bool random() const {
    bool any = flow_random_;
    for (const auto& species : scene_->species) any = any || species.method != scene::SpeciesMethod::deterministic;
    return any;
  }

  std::unique_ptr<Timeline<D>> make_timeline(const base::RandomKey& key) const {
    auto flow = scene::in_motion(*scene_) ? make_live_flow<D>(*scene_, key) : nullptr;
    return std::make_unique<Timeline<D>>(*scene_, stages_, recorder_.layout().times, step_, std::move(flow),
                                         voxel_positions(filling_), filling_.cell, filling_.reserve);
  }

  void derive(const Timeline<D>& timeline) {
    if (scene::in_motion(*scene_))
      derived_.push_back(
          {"flow steps", double(timeline.flow_steps()), "1", "time steps until the end, or until it was steady"});
    if (has_chemistry_)
      derived_.push_back({"intervals", double(intervals_.size()), "1", "of chemistry at frozen geometry"});
    if (timeline.steady_since() >= 0.0) {
      derived_.push_back(
          {"flow steady since", timeline.steady_since(), "s", "from then on it is carried, not computed"});
    }
    for (auto& number : timeline.flow_told()) derived_.push_back(std::move(number));
    if (!geometry_.carries()) return;
    const double deviation = timeline.capacity_deviation();
    derived_.push_back(
        {"largest change of a voxel's capacity", deviation, "1",
         deviation > 0.2 ? "WARNING: above 0.2 concentrations lose accuracy; use a smaller spacing or, for a flow that "
                           "becomes steady, numerics.steady_tolerance"
                         : "by the volume that passed between particles; below 0.2 is good"});
  }

  void record_flow(const Interval<D>& interval, RecordSink& sink) const {
    if (interval.picture) recorder_.flow(std::size_t(interval.record), *interval.picture, sink);
    if (interval.stage) recorder_.volume(std::size_t(interval.record), interval.stage->frame(), sink);
  }

  // One realisation, from its first molecule to its last record.
  bool tell(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome) const {
    const base::RandomKey key{scene_->run.seed, k};
    const auto own_flow = own_flow_ ? make_timeline(key) : nullptr;
    const bool acts_back = scene::acts_back(*scene_);
    Chemistry chemistry(*scene_, network_, key);
    if (has_chemistry_) {
      const auto start = own_flow ? own_flow->start() : start_;
      chemistry.begin(start->ground());
      if (acts_back) own_flow->feel(network_, chemistry.state());
      recorder_.chemistry(0, chemistry.state(), start->frame(), sink);
      if (own_flow) recorder_.volume(0, start->frame(), sink);
    }
    if (own_flow) recorder_.flow(0, *own_flow->start_picture(), sink);
    const auto live = [&](const Interval<D>& interval) {
      if (progress.stop && progress.stop()) return false;
      if (has_chemistry_) {
        chemistry.pass(interval.stage->frame().passages, filling_.cell * scene_->depth, interval.number);
        chemistry.advance(interval.stage->ground(), interval.begin, interval.end - interval.begin, interval.number);
        if (acts_back) own_flow->feel(network_, chemistry.state());
      }
      if (interval.record >= 0) {
        const auto time = std::size_t(interval.record);
        if (has_chemistry_) recorder_.chemistry(time, chemistry.state(), interval.stage->frame(), sink);
        if (own_flow) record_flow(interval, sink);
      }
      if (progress.report) progress.report(interval.end / scene_->run.until);
      return true;
    };
    const bool finished = own_flow ? own_flow->run(live) : std::all_of(intervals_.begin(), intervals_.end(), live);
    if (finished && has_chemistry_) chemistry.close(outcome);
    return finished;
  }

  std::unique_ptr<scene::Scene> scene_;
  rdme::Network network_;
  sph::Filling<D> filling_;
  Geometry<D> geometry_;
  StageBuilder<D> stages_;
  bool has_chemistry_, flow_random_;
  bool own_flow_;  // every realisation has a flow of its own: it is random, or its species act back on it
  Step step_;
  Recorder<D> recorder_;
  std::vector<Derived> derived_;
  std::vector<std::string> notes_;
  std::shared_ptr<const Stage<D>> start_;
  std::vector<Interval<D>> intervals_;  // of the flow that all realisations share
  Outcome alike_;                       // where nothing is random: the outcome of every realisation
};

}  // namespace

std::unique_ptr<Experiment> make_experiment(scene::Scene scene) {
  auto judgement = judge(std::move(scene));
  if (scene::well_mixed(judgement.scene)) return make_well_mixed(std::move(judgement));
  if (judgement.scene.mechanics.motion == scene::Motion::quasi_static) return make_quasi_static(std::move(judgement));
  switch (judgement.scene.dimension) {
    case 1:
      return std::make_unique<ExperimentOf<1>>(std::move(judgement));
    case 2:
      return std::make_unique<ExperimentOf<2>>(std::move(judgement));
    default:
      return std::make_unique<ExperimentOf<3>>(std::move(judgement));
  }
}

}  // namespace shmoo::coupling
