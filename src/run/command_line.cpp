#include "run/command_line.hpp"

#include "run/verbs/verbs.hpp"

namespace shmoo::run {

int command_line(int argc, char** argv) {
  return command_line(argc, argv, {scene::read_scene, coupling::make_experiment, scene::json_schema});
}

}  // namespace shmoo::run
