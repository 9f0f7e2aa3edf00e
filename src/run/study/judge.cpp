#include "run/study/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "run/study/ensemble_errors.hpp"
#include "run/study/grid.hpp"
#include "run/study/needs.hpp"
#include "run/study/reference.hpp"

namespace shmoo::run::study {
namespace {

class Judge {
 public:
  Judge(const scene::Study& study, const std::vector<Task>& tasks, const std::vector<Point>& points, std::size_t q)
      : study_(study), tasks_(tasks), points_(points), q_(q), quantity_(study.quantities[q]) {}

  Verdict verdict() {
    Verdict verdict{.quantity = quantity_.name, .norm = norm_text()};
    for (std::size_t m = 0; m < study_.methods.size(); ++m)
      for (std::size_t l = 0; l < study_.levels.size(); ++l) {
        if (is_reference(m, l) || !study_.methods[m].levels[l]) continue;
        verdict.rows.push_back(row(m, l));
        add_order(verdict.rows);
      }
    mark_pareto(verdict.rows);
    verdict.needs = needs(study_, verdict.rows);
    return verdict;
  }

 private:
  std::string norm_text() const {
    const char* const names[] = {"rms", "root_sum_over_n", "maximum"};
    return fmt::format("{}{}", names[int(quantity_.norm)],
                       quantity_.relative ? ", relative"
                       : quantity_.scale  ? ", scaled"
                                          : "");
  }

  // The run that the others are compared with.
  bool is_reference(std::size_t m, std::size_t l) const {
    const auto& reference = quantity_.reference;
    return reference.type == scene::StudyReference::Type::method && m == reference.method.value_or(m) &&
           (!reference.finest || l + 1 == study_.levels.size());
  }

  std::vector<std::size_t> runs(std::size_t m, std::size_t l) const {
    std::vector<std::size_t> found;
    for (std::size_t t = 0; t < tasks_.size(); ++t)
      if (tasks_[t].method == m && tasks_[t].level == l) found.push_back(t);
    return found;
  }

  Repeats repeats_of(const std::vector<std::size_t>& runs) const {
    Repeats repeats;
    for (const auto t : runs)
      if (points_[t].failure.empty()) repeats.samples.push_back(&points_[t].samples.at(q_));
    repeats.realisations = tasks_[runs.front()].realisations;
    return repeats;
  }

  // Means over repeats, kept because references and counterparts point at them.
  const Sample* mean_of(std::size_t m, std::size_t l) {
    const auto [at, fresh] = means_.try_emplace({m, l});
    if (fresh) {
      const auto found = runs(m, l);
      const auto repeats = found.empty() ? Repeats{} : repeats_of(found);
      if (!repeats.samples.empty()) {
        at->second = *repeats.samples.front();
        at->second.value = mean_over(repeats.samples);
      }
    }
    return at->second.size() > 0 ? &at->second : nullptr;
  }

  bool counts(const Sample& sample, std::size_t i, int dimension) const {
    return !quantity_.region || scene::contains(*quantity_.region, {sample.x[i], sample.y[i], sample.z[i]}, dimension);
  }

  // Reference and weights at the places of the repeats; false where the reference is missing.
  bool compare(const Task& task, Repeats& repeats) {
    const auto& sample = *repeats.samples.front();
    repeats.reference =
        reference_values(study_, quantity_, task, sample, [&](auto m, auto l) { return mean_of(m, l); });
    if (repeats.reference.empty()) return false;
    const double scale = quantity_.scale ? resolved(*quantity_.scale, task) : 1.0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const double divisor = quantity_.relative ? std::abs(repeats.reference[i]) : scale;
      repeats.weight.push_back(counts(sample, i, task.dimension) ? 1.0 / divisor : 0.0);
    }
    return true;
  }

  Counterpart counterpart(std::size_t m, std::size_t l, const Repeats& repeats) {
    const auto other = study_.methods[m].mean_of;
    const auto* mean = other ? mean_of(*other, l) : nullptr;
    if (!mean) return {};
    Counterpart counterpart{.mean = at_places(*mean, *repeats.samples.front())};
    auto theirs = repeats_of(runs(*other, l));
    theirs.reference = repeats.reference;
    theirs.weight = repeats.weight;
    Row row;
    fill_errors(quantity_, theirs, row);
    fill_statistics(theirs, {}, row);
    counterpart.statistical = chance(row) / std::sqrt(double(theirs.samples.size()));
    counterpart.error = row.systematic;
    counterpart.error_seen_from = row.systematic_seen_from;
    return counterpart;
  }

  void fill_cost(const std::vector<std::size_t>& runs, Row& row) const {
    double good = 0.0;
    row.cpu_seconds = row.cpu_per_realisation = row.memory = row.events = 0.0;
    for (const auto t : runs) {
      const auto& point = points_[t];
      if (!point.failure.empty()) continue;
      good += 1.0;
      row.cpu_seconds += point.cpu_seconds;
      row.cpu_per_realisation += point.cpu_per_realisation;
      row.events += point.events;
      row.memory = std::max(row.memory, point.memory);
      row.steps = point.steps;
      row.resolution = point.resolution;
    }
    for (auto* sum : {&row.cpu_seconds, &row.cpu_per_realisation, &row.events}) *sum /= good;
  }

  Row row(std::size_t m, std::size_t l) {
    const auto all = runs(m, l);
    const auto& task = tasks_[all.front()];
    Row row{.method = study_.methods[m].name, .level = study_.levels[l].name, .random = task.random};
    row.repeats = all.size();
    row.realisations = task.realisations;
    if (const auto found = quantity_.published.find(row.method);
        found != quantity_.published.end() && found->second[l] > 0)
      row.published = found->second[l];
    for (const auto t : all)
      if (!points_[t].failure.empty()) row.failure = points_[t].failure;
    auto repeats = repeats_of(all);
    if (repeats.samples.empty()) return row;
    fill_cost(all, row);
    if (!compare(task, repeats)) {
      row.failure = "the run that it is compared with failed";
      return row;
    }
    fill_errors(quantity_, repeats, row);
    if (row.random && study_.methods[m].mean_of) row.mean_of = study_.methods[*study_.methods[m].mean_of].name;
    if (row.random) fill_statistics(repeats, counterpart(m, l, repeats), row);
    return row;
  }

  // Of the last row, from the one before.
  static void add_order(std::vector<Row>& rows) {
    if (rows.size() < 2) return;
    auto& row = rows.back();
    const auto& before = rows[rows.size() - 2];
    if (row.random || before.method != row.method || before.resolution == row.resolution) return;
    row.order = std::log(before.error / row.error) / std::log(before.resolution / row.resolution);
  }

  const scene::Study& study_;
  const std::vector<Task>& tasks_;
  const std::vector<Point>& points_;
  std::size_t q_;
  const scene::StudyQuantity& quantity_;
  std::map<std::pair<std::size_t, std::size_t>, Sample> means_;
};

}  // namespace

std::vector<Verdict> judge(const scene::Study& study, const std::vector<Task>& tasks,
                           const std::vector<Point>& points) {
  std::vector<Verdict> verdicts;
  for (std::size_t q = 0; q < study.quantities.size(); ++q)
    verdicts.push_back(Judge(study, tasks, points, q).verdict());
  return verdicts;
}

}  // namespace shmoo::run::study
