#pragma once
// The command line: one verb, its options, one exit code.
#include <functional>
#include <memory>
#include <string>

#include "coupling/experiment.hpp"
#include "scene/read.hpp"

namespace shmoo::run {

enum ExitCode { exit_done = 0, exit_input = 1, exit_failed = 2, exit_interrupted = 130 };

// Where scenes and experiments come from.
struct Workshop {
  std::function<scene::Scene(const std::string& file, const scene::Overrides& overrides)> read;
  std::function<scene::Scene(const std::string& text, const std::string& file)> read_text;  // of a result
  std::function<std::unique_ptr<coupling::Experiment>(scene::Scene scene)> make;
  std::function<std::string()> schema;
};

// Runs `shmoo VERB ...` and returns its exit code. Never throws.
int command_line(int argc, char** argv);
int command_line(int argc, const char* const* argv, const Workshop& workshop);

}  // namespace shmoo::run
