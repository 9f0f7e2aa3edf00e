// shmoo study STUDY.toml: accuracy against CPU time.
#include <fmt/format.h>

#include <filesystem>
#include <thread>

#include "base/error.hpp"
#include "run/study/grid.hpp"
#include "run/study/picture.hpp"
#include "run/study/point_file.hpp"
#include "run/study/pool.hpp"
#include "run/study/report.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::string study, output, report, jobs;
  bool fresh = false, quiet = false;
};

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw base::InputError(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

int write_report(const Wish& wish) {
  const std::filesystem::path page = wish.output.empty() ? "accuracy.md" : wish.output;
  study::write_whole(page, study::report(wish.report, page));
  fmt::print("{}\n", page.string());
  return exit_done;
}

int run_study(const Wish& wish) {
  if (!wish.report.empty()) return write_report(wish);
  if (wish.study.empty()) throw base::InputError("STUDY is required: the study file, or --report FOLDER");
  const auto study = scene::read_study(wish.study);
  const auto tasks = study::tasks_of(study);
  const std::filesystem::path folder = wish.output.empty() ? study.name + "-study" : wish.output;
  const auto points = folder / "points" / study.name;
  make_folder(points);
  const study::PoolOptions options{.folder = points,
                                   .jobs = wish.jobs.empty() ? std::max(1u, std::thread::hardware_concurrency())
                                                             : std::size_t(whole_number("--jobs", wish.jobs, 1, 4096)),
                                   .fresh = wish.fresh,
                                   .quiet = wish.quiet};
  const auto pool = study::run_tasks(study, tasks, options);
  if (pool.interrupted) {
    fmt::print(stderr, "interrupted: {} keeps what is finished; the same command goes on\n", points.string());
    return exit_interrupted;
  }
  const auto summary = study::summarise(study, tasks, pool.points);
  study::write_summary(folder / (study.name + ".toml"), summary);
  for (const auto& verdict : summary.verdicts)
    study::draw_work_precision(study.title, verdict, folder / fmt::format("{}-{}.png", study.name, verdict.quantity));
  fmt::print("{}", study::printed(summary));
  return summary.failed == summary.runs ? exit_failed : exit_done;
}

}  // namespace

void declare_study(CLI::App& app, Desk& desk) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("study", "Measure errors against CPU time, over methods and resolutions");
  verb->add_option("STUDY", wish->study, "the study file (TOML)");
  verb->add_option("-o,--output", wish->output,
                   "the folder for tables, pictures and finished runs [NAME-study]; of a report, the page");
  verb->add_option("--jobs", wish->jobs, "runs at a time, each with one thread [all cores]");
  verb->add_option("--report", wish->report, "instead: write one page from the summaries in this folder");
  verb->add_flag("--fresh", wish->fresh, "repeat runs that are finished");
  verb->add_flag("--quiet", wish->quiet, "no progress on stderr");
  verb->callback([wish, &desk] { desk.exit_code = run_study(*wish); });
}

}  // namespace shmoo::run
