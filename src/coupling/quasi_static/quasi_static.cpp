#include "coupling/quasi_static/quasi_static.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "coupling/chemistry.hpp"
#include "coupling/quasi_static/step_control.hpp"
#include "coupling/quasi_static/wall_ground.hpp"
#include "coupling/quasi_static/wall_records.hpp"
#include "coupling/schedule.hpp"
#include "coupling/splitting.hpp"

namespace shmoo::coupling {
namespace {

constexpr double lost_in_a_step =
    0.05;  // of a species, by reactions, where these are sampled in turns with what enters

// Besides the usual: the twin of splitting_step knows nothing of what enters at the tip; where that and losses are
// sampled in turns, steps must be short beside the loss.
Step wall_splitting(const scene::Scene& scene, const rdme::Network& network, std::vector<double> reference) {
  reference = reference_concentrations(scene, std::move(reference));
  Step step = splitting_step(scene, network, reference);
  if (scene.numerics.splitting_step || scene.mechanics.sources.empty() || !rdme::takes_turns(scene.numerics.sampler))
    return step;
  double loss = 0.0;
  for (const double rate : turnover(scene, reference)) loss = std::max(loss, rate);
  if (loss * step.value > lost_in_a_step)
    step = {lost_in_a_step / loss, "a twentieth of the time in which reactions use species up that enter at the tip",
            0.0};
  return step;
}

class QuasiStatic final : public Experiment {
 public:
  explicit QuasiStatic(Judgement judgement)
      : scene_(std::move(judgement.scene)),
        notes_(std::move(judgement.notes)),
        network_(scene_),
        plan_(scene_),
        splitting_(wall_splitting(scene_, network_, judgement.reference)),
        records_(plan_, network_, record_times(scene_.run), !random()) {
    if (random() && any(scene::SpeciesMethod::stochastic)) sampler_ = rdme::make_sampler(scene_.numerics, network_);
    derived_ = std::move(judgement.derived);
    describe_wall();
    describe_actions();
  }

  const scene::Scene& scene() const override { return scene_; }
  const RecordLayout& layout() const override { return records_.layout(); }
  std::size_t particles() const override { return records_.material().size(); }
  std::vector<std::int32_t> material_of_particle() const override {
    return {records_.material().begin(), records_.material().end()};
  }
  std::vector<std::array<double, 3>> start_position() const override {
    std::vector<std::array<double, 3>> all;
    for (const auto* group : {&plan_.start.x, &plan_.filling})
      for (const auto& x : *group) all.push_back({plan_.centre + x[0], x[1], 0.0});
    return all;
  }
  std::vector<Derived> derived() const override { return derived_; }
  std::vector<std::string> notes() const override { return notes_; }

  bool prepare(RecordSink& sink, const Progress& progress) override {
    if (random()) return true;
    StepControl control(scene_, false);
    const bool finished = tell(0, sink, progress, alike_, control);
    describe_steps(control);
    return finished;
  }

  bool realise(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome) override {
    StepControl control(scene_, true);
    if (random()) return tell(k, sink, progress, outcome, control);
    outcome = alike_;
    return true;
  }

 private:
  bool any(scene::SpeciesMethod method) const {
    return std::any_of(scene_.species.begin(), scene_.species.end(),
                       [&](const auto& one) { return one.method == method; });
  }
  bool random() const { return any(scene::SpeciesMethod::stochastic) || any(scene::SpeciesMethod::langevin); }

  void describe_wall() {
    const auto& start = plan_.start;
    derived_.push_back(macro_step());
    derived_.push_back({"wall layers", double(start.layers), "1", "thickness over domain.spacing"});
    derived_.push_back({"wall columns", double(start.columns), "1", "along half the outline"});
    derived_.push_back({"length under turgor", plan_.length, "m", "from tip to back, before anything grows"});
    if (scene_.species.empty()) return;
    derived_.push_back({"splitting_step", splitting_.value, "s", splitting_.why});
    if (splitting_.error > 0.0) derived_.push_back(splitting_error(splitting_));
  }

  Derived macro_step() const {
    const StepControl control(scene_, random());
    if (control.controlled())
      return {"first macro step", control.step(), "s", "the next as mechanics.tolerance of the length allows"};
    return {"macro step", control.step(), "s",
            scene_.mechanics.step ? "as given"
                                  : "2 mechanics.tolerance x run.until: a step of first order is late by half of it"};
  }

  void describe_steps(const StepControl& control) {
    derived_.push_back({"macro steps", double(control.steps()), "1", "from equilibrium to equilibrium"});
    derived_.push_back({"shortest macro step", control.shortest(), "s", "of all"});
    derived_.push_back({"longest macro step", control.longest(), "s", "of all"});
    derived_.push_back({"error of the length by steps", control.error(), "m",
                        "sum of half of what every step did otherwise than the one before foretold"});
  }

  // What acts on the wall, and is not there unless the scene says so.
  void describe_actions() {
    const auto& elastic = plan_.elastic();
    const auto& mechanics = scene_.mechanics;
    const auto name = [&](int species) { return scene_.species[std::size_t(species)].name; };
    derived_.push_back({"turgor", mechanics.turgor, "Pa", "present: mechanics.turgor"});
    if (elastic.softening)
      derived_.push_back({"softening", elastic.softening->coefficient, "m^3/molecule",
                          "present: by " + name(elastic.softening->species)});
    if (elastic.growth)
      derived_.push_back({"growth", elastic.growth->coefficient, "m^3/(molecule Pa s)",
                          "present: by " + name(elastic.growth->species)});
    for (const auto& source : mechanics.sources)
      derived_.push_back({"source of " + name(source.species), source.rate, "1/s",
                          fmt::format("present: within about {:g} m of the tip", source.width)});
  }

  // Chemistry from t to `end` on ground that keeps its shape.
  void react(Chemistry& chemistry, const std::shared_ptr<const Ground>& ground, double t, double end,
             std::uint64_t& interval) const {
    while (t < end) {
      const double until = interval_end(t, splitting_.value, end);
      chemistry.advance(ground, t, until - t, interval++);
      t = until;
    }
  }

  // [molecules/m^3] by species and particle of the wall.
  std::vector<std::vector<double>> concentrations(const rdme::State& state, const Ground& ground) const {
    std::vector<std::vector<double>> all(state.species);
    for (std::size_t s = 0; s < state.species; ++s) {
      for (std::size_t i = 0; i < plan_.start.size(); ++i) {
        const std::size_t entry = i * state.species + s;
        const double amount = network_.stochastic(int(s)) ? double(state.count[entry]) : state.amount[entry];
        all[s].push_back(amount / ground.voxels.volume[i]);
      }
    }
    return all;
  }

  bool tell(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome, StepControl& control) const {
    const base::RandomKey key{scene_.run.seed, k};
    Wall wall(plan_);
    Chemistry chemistry(scene_, network_, key);
    chemistry.begin(wall_ground(plan_, wall, sampler_.get()));
    const auto& times = records_.layout().times;
    records_.read(0, wall, chemistry.state(), sink);
    double t = 0.0;
    std::uint64_t interval = 0, step = 0;
    for (std::size_t record = 1; record < times.size(); ++record) {
      while (t < times[record]) {
        if (progress.stop && progress.stop()) return false;
        const double end = interval_end(t, control.step(), times[record]);
        const double length = wall.length();
        const auto ground = wall_ground(plan_, wall, sampler_.get());
        react(chemistry, ground, t, end, interval);
        wall.advance(end, end - t, concentrations(chemistry.state(), *ground));
        control.learn(end - t, wall.length() - length, wall.length());
        const auto takes = wall.rezone(end);
        if (!takes.empty()) {
          chemistry.change([&](rdme::State& state) { redistribute(state, network_, takes, key, step); });
        }
        t = end;
        ++step;
        if (progress.report) progress.report(t / scene_.run.until);
      }
      records_.read(record, wall, chemistry.state(), sink);
    }
    chemistry.close(outcome);
    return true;
  }

  scene::Scene scene_;
  std::vector<std::string> notes_;
  rdme::Network network_;
  WallPlan plan_;
  Step splitting_;
  WallRecords records_;
  std::unique_ptr<rdme::Sampler> sampler_;  // only derives tables; null where no species is stochastic
  std::vector<Derived> derived_;
  Outcome alike_;  // where nothing is random: the outcome of every realisation
};

}  // namespace

std::unique_ptr<Experiment> make_quasi_static(Judgement judgement) {
  return std::make_unique<QuasiStatic>(std::move(judgement));
}

}  // namespace shmoo::coupling
