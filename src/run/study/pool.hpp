#pragma once
// Runs the tasks of a study as processes, several at a time, and keeps what is finished.
#include <filesystem>
#include <vector>

#include "run/study/point.hpp"

namespace shmoo::run::study {

struct PoolOptions {
  std::filesystem::path folder;  // one file per finished run
  std::size_t jobs = 1;
  bool fresh = false;  // repeat what is there
  bool quiet = false;
};

struct Pool {
  std::vector<Point> points;  // [task]; those not reached are failures
  bool interrupted = false;
};

// Finished points are read instead of run; cheap tasks go first.
Pool run_tasks(const scene::Study& study, const std::vector<Task>& tasks, const PoolOptions& options);

}  // namespace shmoo::run::study
