// shmoo check MODEL: reads and validates, looks at the limits of what moves, and computes nothing.
#include <fmt/format.h>

#include "coupling/rules/judgement.hpp"
#include "run/verbs/verbs.hpp"
#include "scene/motion.hpp"
#include "scene/well.hpp"

namespace shmoo::run {

void declare_check(CLI::App& app, Desk& desk) {
  struct Wish {
    std::string model;
    std::vector<std::string> settings;
  };
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("check", "Read a model and report every mistake; computes nothing");
  verb->add_option("MODEL", wish->model, "the model file (TOML)")->required();
  verb->add_option("--set", wish->settings, "path=value: replace a value of the model; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  verb->callback([wish, &desk] {
    const auto scene = desk.workshop.read(wish->model, overrides_of(wish->settings));
    if (scene::well_mixed(scene)) {
      fmt::print("{}: no mistakes (\"{}\", well mixed, {} compartments, {} species, {} reactions, {} events)\n",
                 wish->model, scene.title, scene.compartments.size(), scene.species.size(), scene.reactions.size(),
                 scene.events.size());
      return;
    }
    if (scene::in_motion(scene)) coupling::judge(scene);  // throws where the run could never finish
    fmt::print("{}: no mistakes (\"{}\", {}-D, {} materials, {} species, {} reactions)\n", wish->model, scene.title,
               scene.dimension, scene.materials.size(), scene.species.size(), scene.reactions.size());
  });
}

}  // namespace shmoo::run
