// shmoo explain MODEL: what would be simulated and what not, why, and what it costs.
#include <fmt/format.h>
#include <omp.h>

#include "base/clock.hpp"
#include "run/explain/memory.hpp"
#include "run/explain/report.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::string model;
  std::vector<std::string> settings;
  std::string threads;
  bool json = false, unmeasured = false;
};

constexpr double flow_budget = 1.0, run_budget = 1.2;  // [s] of CPU time

// What has to be run to be known.
void measure(Report& report, const Workshop& workshop, const coupling::RecordLayout& layout, int threads,
             const Idle& idle) {
  const auto& scene = report.decided.scene;
  const auto& numbers = report.decided.numbers;
  if (scene.effects.flow) report.flow = coupling::measure_flow(scene, threads, flow_budget);
  if (report.flow) {
    const double pace = double(report.flow->particles) / report.flow->step_seconds * report.flow->speedup;
    report.limits = coupling::judge_limits(scene, numbers, {.particle_steps = pace, .measured = true});
  }
  omp_set_num_threads(1);  // CPU time is that of one thread, as in an ensemble
  report.forecast = make_forecast(scene, numbers, report.flow, workshop.make, layout, threads, idle, run_budget);
}

void explain(const Wish& wish, const Workshop& workshop) {
  Idle idle{heap_bytes(), 0.0};
  const int threads =
      wish.threads.empty() ? omp_get_max_threads() : static_cast<int>(whole_number("--threads", wish.threads, 1, 4096));
  Report report{coupling::decide(workshop.read(wish.model, overrides_of(wish.settings))), {}, {}, {}, {}, {}};
  idle.seconds = base::cpu_seconds();
  auto scene = report.decided.scene;
  report.numbers = telling_numbers(scene, report.decided.numbers);
  report.limits = coupling::judge_limits(scene, report.decided.numbers);
  scene.numerics.limits = scene::Limits::warn;  // to be told, not to be stopped by
  auto experiment = workshop.make(std::move(scene));
  report.derived = experiment->derived();
  const auto layout = experiment->layout();
  experiment.reset();
  if (!wish.unmeasured) measure(report, workshop, layout, threads, idle);
  if (wish.json)
    fmt::print("{}\n", as_json(report).dump(2));
  else
    fmt::print("{}", as_text(report));
}

}  // namespace

void declare_explain(CLI::App& app, Desk& desk) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("explain", "Say what of a model is computed and what not, why, and what it costs");
  verb->add_option("MODEL", wish->model, "the model file (TOML)")->required();
  verb->add_flag("--json", wish->json, "as JSON");
  verb->add_option("--threads", wish->threads, "threads that a run would use [all]");
  verb->add_flag("--unmeasured", wish->unmeasured, "leave out costs and forecast, which take seconds to measure");
  verb->add_option("--set", wish->settings, "path=value: replace a value of the model; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  verb->callback([wish, &desk] { explain(*wish, desk.workshop); });
}

}  // namespace shmoo::run
