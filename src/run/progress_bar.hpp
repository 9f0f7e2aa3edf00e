#pragma once
// What a waiting user sees on stderr: a bar with the time left on a terminal, a plain line now and then elsewhere.
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace shmoo::run {

class ProgressBar {
 public:
  enum class Style { quiet, lines, bar };
  static Style style_for(bool quiet);  // bar where stderr is a terminal

  // `total` pieces of work of which `done` were finished before; at most `workers` are under way at once.
  ProgressBar(std::string label, std::size_t total, std::size_t done, std::size_t workers, Style style);
  ~ProgressBar();

  void report(std::size_t worker, double fraction);  // of the worker's piece, in [0, 1]; any thread
  void finish_one(std::size_t worker);
  void end();  // last line; further calls do nothing

 private:
  using Clock = std::chrono::steady_clock;
  double finished_fraction() const;
  std::string text() const;
  void show(bool last);

  std::string label_;
  std::size_t total_, done_before_;
  Style style_;
  Clock::time_point start_ = Clock::now(), shown_{};
  std::atomic<std::size_t> done_;
  std::vector<std::atomic<double>> under_way_;
  std::mutex showing_;
  double shown_fraction_ = -1;
  bool ended_ = false;
};

// "3 s", "4 min 10 s", "2 h 5 min"
std::string duration_text(double seconds);

}  // namespace shmoo::run
