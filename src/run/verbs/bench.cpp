// shmoo bench: how fast each method is on named workloads, on this machine.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "run/bench/workload.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::vector<std::string> workloads, methods;
  std::string seconds, threads;
  bool list = false, json = false;
};

bool named(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

void refuse_unknown(const std::vector<std::string>& wanted, std::string bench::Workload::*member, const char* kind,
                    const std::vector<bench::Workload>& all) {
  for (const auto& name : wanted) {
    std::vector<std::string> known;
    for (const auto& one : all)
      if (known.empty() || known.back() != one.*member) known.push_back(one.*member);
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    throw base::InputError(fmt::format("there is no {} '{}'; there are: {}", kind, name, fmt::join(known, ", ")));
  }
}

void print(const bench::Workload& work, const bench::Measurement& m) {
  fmt::print("{:<11} {:<28} {:>10.4g} {:<30} {:>7.1f} B   {}{}\n", work.name, work.method, m.rate, work.unit,
             m.bytes_per_voxel, m.right ? "" : "WRONG: ", m.check);
  std::fflush(stdout);
}

void print_json(const bench::Workload& work, const bench::Measurement& m) {
  const nlohmann::json line = {{"workload", work.name},
                               {"method", work.method},
                               {"rate", m.rate},
                               {"unit", work.unit},
                               {"cpu_seconds", m.cpu_seconds},
                               {"bytes_per_voxel", m.bytes_per_voxel},
                               {"row_bytes_per_voxel", m.row_bytes_per_voxel},
                               {"check", m.check},
                               {"right", m.right}};
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

double seconds_of(const Wish& wish) {
  if (wish.seconds.empty()) return 2.0;
  char* end = nullptr;
  const double seconds = std::strtod(wish.seconds.c_str(), &end);
  if (*end != '\0' || !(seconds > 0.0 && seconds <= 3600.0))
    throw base::InputError(
        fmt::format("--seconds got '{}'; it must be a number of CPU seconds above 0 and up to 3600", wish.seconds));
  return seconds;
}

int run_bench(const Wish& wish) {
  auto all = bench::chemistry_workloads();
  for (auto& work : bench::geometry_workloads()) all.push_back(std::move(work));
  for (auto& work : bench::smooth_workloads()) all.push_back(std::move(work));
  for (auto& work : bench::flow_workloads()) all.push_back(std::move(work));
  for (auto& work : bench::solid_workloads()) all.push_back(std::move(work));
  for (const auto& name : wish.workloads)
    if (std::ranges::find(all, name, &bench::Workload::name) == all.end())
      for (auto& work : bench::lattice_workloads(name)) all.push_back(std::move(work));
  refuse_unknown(wish.workloads, &bench::Workload::name, "workload", all);
  refuse_unknown(wish.methods, &bench::Workload::method, "method", all);
  const double seconds = seconds_of(wish);
  omp_set_num_threads(wish.threads.empty() ? 1 : static_cast<int>(whole_number("--threads", wish.threads, 1, 4096)));
  bool right = true;
  for (const auto& work : all) {
    if (!named(wish.workloads, work.name) || !named(wish.methods, work.method)) continue;
    if (wish.list) {
      fmt::print("{:<11} {}\n", work.name, work.method);
      continue;
    }
    const auto measurement = work.measure(seconds);
    wish.json ? print_json(work, measurement) : print(work, measurement);
    right = right && measurement.right;
  }
  return right ? exit_done : exit_failed;
}

}  // namespace

void declare_bench(CLI::App& app, Desk& desk) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("bench", "Measure how fast each method is on this machine");
  verb->add_option("WORKLOAD", wish->workloads, "only these workloads; D3-n and RD-n with any n from 3 to 200 [all]");
  verb->add_option("--method", wish->methods, "only this method; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  verb->add_option("--seconds", wish->seconds, "CPU seconds to spend on each [2]");
  verb->add_option("--threads", wish->threads, "threads that one run may use; CPU seconds are of all of them [1]");
  verb->add_flag("--list", wish->list, "name workloads and methods instead");
  verb->add_flag("--json", wish->json, "one object a line");
  verb->callback([wish, &desk] { desk.exit_code = run_bench(*wish); });
}

}  // namespace shmoo::run
