// shmoo import NETWORK.xml -o MODEL.toml: an SBML network as a model file.
#include <fmt/format.h>

#include <fstream>

#include "base/error.hpp"
#include "run/ensemble.hpp"
#include "run/verbs/verbs.hpp"
#include "scene/document.hpp"
#include "scene/sbml/import.hpp"

namespace shmoo::run {

void declare_import(CLI::App& app, Desk&) {
  struct Wish {
    std::string network, output;
    bool force = false;
  };
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("import", "Write an SBML network as a model file");
  verb->add_option("NETWORK.xml", wish->network, "the network, SBML Level 2 or 3")->required();
  verb->add_option("-o,--output", wish->output, "the model file (TOML)")->required();
  verb->add_flag("--force", wish->force, "replace an existing file");
  verb->callback([wish] {
    require_writable(wish->output);
    if (!wish->force && std::filesystem::exists(wish->output))
      throw base::InputError(fmt::format("{} exists; --force replaces it, -o OTHER.toml leaves it", wish->output));
    const auto model = scene::import_sbml(scene::read_bytes(wish->network, "network"), wish->network);
    const auto read = scene::read_scene_text(model, wish->output);
    std::ofstream(wish->output, std::ios::binary) << model;
    fmt::print("{}: {} species, {} reactions, {} events; look at its [run]\n", wish->output, read.species.size(),
               read.reactions.size(), read.events.size());
  });
}

}  // namespace shmoo::run
