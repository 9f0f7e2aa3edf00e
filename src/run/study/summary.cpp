#include "run/study/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <set>
#include <thread>

#include "run/description.hpp"

namespace shmoo::run::study {
namespace {

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace

Summary summarise(const scene::Study& study, const std::vector<Task>& tasks, const std::vector<Point>& points) {
  Summary summary{.title = study.title, .regime = study.regime, .name = study.name, .model = study.model};
  summary.date = utc_now().substr(0, 10);
  summary.processor = processor_name();
  summary.compiler = build().compiler;
  summary.cores = std::max(1u, std::thread::hardware_concurrency());
  summary.runs = points.size();
  std::set<std::string> revisions;
  for (const auto& point : points) {
    summary.cpu_seconds += point.cpu_seconds;
    if (!point.failure.empty()) ++summary.failed;
    if (!point.revision.empty()) revisions.insert(point.revision);
  }
  summary.revisions = fmt::format("{}", fmt::join(revisions, ", "));
  summary.verdicts = judge(study, tasks, points);
  return summary;
}

}  // namespace shmoo::run::study
