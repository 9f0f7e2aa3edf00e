#pragma once
// What is kept of a study: its verdicts, and where they were made. A plain TOML file, from which reports are written.
#include <filesystem>

#include "run/study/judge.hpp"

namespace shmoo::run::study {

struct Summary {
  std::string title{}, regime{}, name{}, model{};
  std::string date{}, processor{}, compiler{};
  std::string revisions{};  // of the program that made the points
  std::size_t cores = 1, runs = 0, failed = 0;
  double cpu_seconds = 0;  // of all runs
  std::vector<Verdict> verdicts{};
};

Summary summarise(const scene::Study& study, const std::vector<Task>& tasks, const std::vector<Point>& points);

void write_summary(const std::filesystem::path& path, const Summary& summary);
Summary read_summary(const std::filesystem::path& path);  // base::InputError where it is none

}  // namespace shmoo::run::study
