#include "run/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace shmoo::run {

ProgressBar::Style ProgressBar::style_for(bool quiet) {
  if (quiet) return Style::quiet;
  return isatty(STDERR_FILENO) != 0 ? Style::bar : Style::lines;
}

ProgressBar::ProgressBar(std::string label, std::size_t total, std::size_t done, std::size_t workers, Style style)
    : label_(std::move(label)),
      total_(std::max<std::size_t>(1, total)),
      done_before_(done),
      style_(style),
      done_(done),
      under_way_(workers) {
  for (auto& fraction : under_way_) fraction.store(0.0);
  if (style_ != Style::quiet) show(false);
}

ProgressBar::~ProgressBar() { end(); }

double ProgressBar::finished_fraction() const {
  double sum = static_cast<double>(done_.load());
  for (const auto& fraction : under_way_) sum += fraction.load();
  return std::min(1.0, sum / static_cast<double>(total_));
}

std::string ProgressBar::text() const {
  const double fraction = finished_fraction();
  const double before = static_cast<double>(done_before_) / static_cast<double>(total_);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string text = fmt::format("{} {:3.0f} %", label_, std::floor(100 * fraction));
  if (total_ > 1) text += fmt::format(", {} of {}", done_.load(), total_);
  if (fraction >= 1.0) return text + fmt::format(", took {}", duration_text(elapsed));
  if (fraction > before && elapsed > 0.5)
    text += fmt::format(", {} left", duration_text(elapsed * (1 - fraction) / (fraction - before)));
  return text;
}

void ProgressBar::show(bool last) {
  const std::unique_lock lock(showing_, std::try_to_lock);
  if (!lock.owns_lock() && !last) return;
  const auto now = Clock::now();
  const double since = std::chrono::duration<double>(now - shown_).count();
  const double fraction = finished_fraction();
  if (style_ == Style::bar) {
    if (!last && since < 0.1) return;
    constexpr int width = 30;
    const auto filled = static_cast<int>(width * fraction);
    std::string bar;
    for (int i = 0; i < width; ++i) bar += i < filled ? "█" : "·";
    fmt::print(stderr, "\r\033[K{} {}{}", bar, text(), last ? "\n" : "");
  } else {
    // At the start; then a tenth of the work and two seconds apart, or half a minute; at the end.
    const bool due = shown_fraction_ < 0 || (fraction >= shown_fraction_ + 0.1 && since > 2.0) || since > 30.0;
    if (!last && !due) return;
    fmt::print(stderr, "{}\n", text());
  }
  std::fflush(stderr);
  shown_ = now;
  shown_fraction_ = fraction;
}

void ProgressBar::report(std::size_t worker, double fraction) {
  if (style_ == Style::quiet) return;
  under_way_[worker].store(std::clamp(fraction, 0.0, 1.0));
  show(false);
}

void ProgressBar::finish_one(std::size_t worker) {
  under_way_[worker].store(0.0);
  done_.fetch_add(1);
  if (style_ != Style::quiet) show(false);
}

void ProgressBar::end() {
  if (ended_ || style_ == Style::quiet) return;
  show(true);
  ended_ = true;
}

std::string duration_text(double seconds) {
  const auto s = static_cast<long long>(std::llround(seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
  return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

}  // namespace shmoo::run
