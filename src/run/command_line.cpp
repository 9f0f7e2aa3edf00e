#include "run/command_line.hpp"

#include "run/verbs/verbs.hpp"

namespace shmoo::run {

int command_line(int argc, char** argv) {
  const auto read_text = [](const std::string& text, const std::string& file) {
    return scene::read_scene_text(text, file);
  };
  return command_line(argc, argv, {scene::read_scene, read_text, coupling::make_experiment, scene::json_schema});
}

}  // namespace shmoo::run
