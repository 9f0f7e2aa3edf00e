#include "run/study/pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <numeric>
#include <thread>

#include "base/error.hpp"
#include "run/interrupt.hpp"
#include "run/progress_bar.hpp"
#include "run/study/child.hpp"
#include "run/study/point_file.hpp"
#include "run/study/sample.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run::study {
namespace {

constexpr auto look_interval = std::chrono::milliseconds(10);

class Runner {
 public:
  Runner(const scene::Study& study, const std::vector<Task>& tasks, const PoolOptions& options)
      : study_(study), tasks_(tasks), options_(options) {
    pool_.points.resize(tasks.size());
  }

  Pool run() {
    for (const auto t : cheap_first()) {
      auto kept = options_.fresh ? std::nullopt : read_point(file(t, ".toml"), tasks_[t]);
      if (kept)
        pool_.points[t] = std::move(*kept);
      else
        waiting_.push_back(t);
    }
    finished_ = tasks_.size() - waiting_.size();
    if (finished_ > 0) say(fmt::format("{} of {} runs are there already", finished_, tasks_.size()));
    const InterruptGuard guard;
    while (!(waiting_.empty() && under_way_.empty()) && !interrupt_requested()) {
      while (!waiting_.empty() && under_way_.size() < options_.jobs) start();
      collect();
      std::this_thread::sleep_for(look_interval);
    }
    pool_.interrupted = interrupt_requested();
    for (const auto t : waiting_) pool_.points[t].failure = "not run";
    for (const auto& [t, child] : under_way_) pool_.points[t].failure = "interrupted";
    return std::move(pool_);
  }

 private:
  std::vector<std::size_t> cheap_first() const {
    std::vector<std::size_t> order(tasks_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return tasks_[a].work < tasks_[b].work; });
    return order;
  }

  std::filesystem::path file(std::size_t t, const char* end) const { return options_.folder / (tasks_[t].name + end); }

  std::vector<std::string> words(std::size_t t) const {
    const auto& task = tasks_[t];
    std::vector<std::string> all{"/proc/self/exe",
                                 "run",
                                 study_.model,
                                 "-o",
                                 file(t, ".h5").string(),
                                 "-n",
                                 std::to_string(task.realisations),
                                 "--seed",
                                 std::to_string(task.seed),
                                 "--threads",
                                 "1",
                                 "--quiet",
                                 "--force"};
    for (const auto& [path, value] : task.overrides) all.insert(all.end(), {"--set", path + "=" + value});
    return all;
  }

  void start() {
    const auto t = waiting_.front();
    waiting_.erase(waiting_.begin());
    under_way_.emplace_back(t, Child(words(t), file(t, ".log"), study_.budget));
  }

  void collect() {
    for (auto at = under_way_.begin(); at != under_way_.end();) {
      const auto end = at->second.poll();
      if (end) {
        finish(at->first, *end);
        at = under_way_.erase(at);
      } else {
        ++at;
      }
    }
  }

  void finish(std::size_t t, const Ending& end) {
    Point point{
        .failure = end.failure, .cpu_seconds = end.cpu_seconds, .wall_seconds = end.wall_seconds, .memory = end.memory};
    auto line = words(t);
    line.front() = "shmoo";
    point.command = shell_line(line);
    if (point.failure.empty()) try {
        const ResultFile result(file(t, ".h5"));
        take_account(result, study_, tasks_[t], point);
        for (const auto& quantity : study_.quantities) point.samples.push_back(take(result, quantity));
      } catch (const std::exception& error) {
        point.failure = error.what();
      }
    std::error_code ignored;
    for (const auto* end_of_name : {".h5", ".h5.part", ".log"}) std::filesystem::remove(file(t, end_of_name), ignored);
    write_point(file(t, ".toml"), tasks_[t], point);
    ++finished_;
    say(fmt::format(
        "{} of {}: {} at {}{}: {}", finished_, tasks_.size(), study_.methods[tasks_[t].method].name,
        study_.levels[tasks_[t].level].name,
        tasks_[t].repeat > 0 ? fmt::format(" (repeat {})", tasks_[t].repeat + 1) : "",
        point.failure.empty() ? fmt::format("{:.2f} CPU s", point.cpu_seconds) : "FAILED: " + point.failure));
    pool_.points[t] = std::move(point);
  }

  void say(const std::string& text) const {
    if (!options_.quiet) fmt::print(stderr, "{}\n", text);
  }

  const scene::Study& study_;
  const std::vector<Task>& tasks_;
  const PoolOptions& options_;
  Pool pool_;
  std::vector<std::size_t> waiting_;
  std::list<std::pair<std::size_t, Child>> under_way_;
  std::size_t finished_ = 0;
};

}  // namespace

Pool run_tasks(const scene::Study& study, const std::vector<Task>& tasks, const PoolOptions& options) {
  return Runner(study, tasks, options).run();
}

}  // namespace shmoo::run::study
