// shmoo explain MODEL: what would be simulated and what not, why, and what it costs.
#include <fmt/format.h>

#include "run/explain/report.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::string model;
  std::vector<std::string> settings;
  bool json = false;
};

void explain(const Wish& wish, const Workshop& workshop) {
  Report report{coupling::decide(workshop.read(wish.model, overrides_of(wish.settings))), {}, {}, {}};
  auto scene = report.decided.scene;
  report.numbers = telling_numbers(scene, report.decided.numbers);
  report.limits = coupling::judge_limits(scene, report.decided.numbers);
  scene.numerics.limits = scene::Limits::warn;  // to be told, not to be stopped by
  report.derived = workshop.make(std::move(scene))->derived();
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
  verb->add_option("--set", wish->settings, "path=value: replace a value of the model; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  verb->callback([wish, &desk] { explain(*wish, desk.workshop); });
}

}  // namespace shmoo::run
