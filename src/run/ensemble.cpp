#include "run/ensemble.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "run/interrupt.hpp"
#include "run/result_write.hpp"
#include "run/results.hpp"

namespace shmoo::run {
namespace {

using Clock = std::chrono::steady_clock;
using base::cpu_seconds;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Ensemble {
 public:
  Ensemble(coupling::Experiment& experiment, const EnsembleOptions& options)
      : experiment_(experiment),
        options_(options),
        description_(experiment),
        results_(experiment.layout(), experiment.scene().species.size(), options.realisations),
        collector_(results_) {
    provenance_.host = host_name();
    provenance_.started = utc_now();
    provenance_.threads = options.threads;
    provenance_.command = options.command;
    if (options.resume) {
      restore_result(options.output, description_, results_);
      was_done_ = glance_at(options.output).status == "done";
    }
    done_before_ = results_.done_count();
  }

  EnsembleEnd run() {
    if (was_done_ && results_.complete()) return end();
    write({"running", ""});
    try {
      if (prepare()) realise_all();
    } catch (const std::exception& error) {
      failure_ = error.what();
    }
    if (failure_) {
      write({"failed", *failure_});
      throw base::RunError(*failure_);
    }
    write({results_.complete() ? "done" : part_complete() ? "part" : "interrupted", ""});
    return end();
  }

 private:
  bool mine(std::size_t k) const { return k % options_.parts == options_.part; }
  bool part_complete() const {
    for (std::size_t k = 0; k < results_.done.size(); ++k)
      if (mine(k) && results_.done[k] == 0) return false;
    return true;
  }

  EnsembleEnd end() const {
    bool balanced = true;
    for (std::size_t k = 0; k < results_.done.size(); ++k)
      balanced = balanced && (results_.done[k] == 0 || results_.balanced[k] != 0);
    return {!part_complete(), results_.done_count(), results_.done.size(), balanced, seconds_since(start_)};
  }

  // What all realisations share.
  bool prepare() {
    omp_set_num_threads(options_.threads);
    malloc_trim(0);  // what reading and building the scene needed for a moment goes back
    const double before = cpu_seconds();
    ProgressBar bar("shared by all realisations", 1, 0, 1, options_.progress);
    Recorder recorder(results_.layout, Recorder::Source::preparation);
    coupling::Progress progress{interrupt_requested, [&](double fraction) { bar.report(0, fraction); }};
    if (!experiment_.prepare(recorder, progress)) return false;
    recorder.require_complete();
    collector_.share(recorder);
    description_.derived = experiment_.derived();
    provenance_.cpu_seconds_shared = cpu_seconds() - before;
    return true;
  }

  void realise_all() {
    for (std::uint32_t k = 0; k < results_.done.size(); ++k) {
      if (mine(k) && results_.done[k] == 0) waiting_.push_back(k);
    }
    if (waiting_.empty()) return;
    const auto workers = std::min<std::size_t>(waiting_.size(), static_cast<std::size_t>(options_.threads));
    ProgressBar bar("realisations", results_.done.size(), results_.done_count(), workers, options_.progress);
    written_ = Clock::now();
    cpu_before_ = cpu_seconds();
    done_before_ = results_.done_count();
    std::vector<std::jthread> threads;
    for (std::size_t w = 0; w < workers; ++w) threads.emplace_back([&, w] { work(w, workers, bar); });
  }

  // One worker: realisations in turn until none waits. Threads that no realisation uses work inside one.
  void work(std::size_t worker, std::size_t workers, ProgressBar& bar) {
    omp_set_num_threads(std::max(1, options_.threads / static_cast<int>(workers)));
    coupling::Progress progress{[&] { return stop(); }, [&](double fraction) { bar.report(worker, fraction); }};
    while (!stop()) {
      const auto next = next_.fetch_add(1);
      if (next >= waiting_.size()) return;
      const auto k = waiting_[next];
      try {
        Recorder recorder(results_.layout, Recorder::Source::realisation);
        coupling::Outcome outcome;
        if (!experiment_.realise(k, recorder, progress, outcome)) return;
        recorder.require_complete();
        if (!shared_.exchange(true)) collector_.share(recorder);
        collector_.add(k, recorder, outcome);
        bar.finish_one(worker);
        write_if_due();
      } catch (const std::exception& error) {
        fail(fmt::format("realisation {}: {}", k, error.what()));
      }
    }
  }

  bool stop() const { return failed_.load() || interrupt_requested(); }

  void fail(const std::string& message) {
    const std::scoped_lock lock(failing_);
    if (!failure_) failure_ = message;
    failed_.store(true);
  }

  void write_if_due() {
    const std::unique_lock lock(writing_, std::try_to_lock);
    if (!lock.owns_lock() || seconds_since(written_) < std::max(options_.write_interval, 20 * writing_took_)) return;
    write({"running", ""});
  }

  void write(const Status& status) {
    const auto start = Clock::now();
    malloc_trim(0);  // what realisations left makes room
    collector_.at_rest([&](const Results& results) {
      provenance_.updated = utc_now();
      provenance_.seconds = seconds_since(start_);
      const auto finished = results.done_count() - done_before_;
      if (finished > 0)
        provenance_.cpu_seconds_per_realisation = (cpu_seconds() - cpu_before_) / static_cast<double>(finished);
      write_result(options_.output, description_, results, status, provenance_);
    });
    malloc_trim(0);  // the library has filled caches and freed them
    written_ = Clock::now();
    writing_took_ = seconds_since(start);
  }

  coupling::Experiment& experiment_;
  const EnsembleOptions& options_;
  Description description_;
  Results results_;
  Collector collector_;
  Provenance provenance_;
  bool was_done_ = false;  // the file that is resumed
  Clock::time_point start_ = Clock::now(), written_ = start_;
  double writing_took_ = 0;  // [s]
  double cpu_before_ = 0;    // [s] when the first realisation of this session began
  std::size_t done_before_ = 0;
  std::vector<std::uint32_t> waiting_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false}, shared_{false};
  std::optional<std::string> failure_;
  std::mutex failing_, writing_;
};

}  // namespace

EnsembleEnd run_ensemble(coupling::Experiment& experiment, const EnsembleOptions& options) {
  if (options.realisations < 1 || options.realisations > base::sample_limit) {
    throw base::InputError(
        fmt::format("{} realisations; between 1 and {} are possible", options.realisations, base::sample_limit));
  }
  const InterruptGuard guard;
  return Ensemble(experiment, options).run();
}

void require_writable(const std::filesystem::path& output) {
  const auto folder = output.has_parent_path() ? output.parent_path() : std::filesystem::path(".");
  const auto refuse = [&](const std::string& why) {
    throw base::InputError(fmt::format("cannot write {}: {}", output.string(), why));
  };
  std::error_code ignored;
  if (!std::filesystem::exists(folder, ignored))
    refuse(fmt::format("the folder {} does not exist; make it first", folder.string()));
  if (!std::filesystem::is_directory(folder, ignored)) refuse(fmt::format("{} is not a folder", folder.string()));
  if (std::filesystem::is_directory(output, ignored)) refuse("it is a folder; name a file in it");
  auto part = output;
  part += ".part";
  {
    std::ofstream probe(part, std::ios::app);
    if (!probe) refuse(fmt::format("no files can be made in {}", folder.string()));
  }
  std::filesystem::remove(part, ignored);
}

}  // namespace shmoo::run
