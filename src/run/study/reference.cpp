#include "run/study/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/exact_solutions.hpp"
#include "run/study/csv_table.hpp"
#include "run/study/grid.hpp"

namespace shmoo::run::study {
namespace {

using Type = scene::StudyReference::Type;

std::vector<double> by_formula(const scene::StudyReference& reference, const Task& task, const Sample& sample) {
  const auto& solution = *base::find_exact_solution(reference.formula);
  std::vector<double> parameters, values;
  for (const auto& number : reference.parameters) parameters.push_back(resolved(number, task));
  for (std::size_t i = 0; i < sample.size(); ++i)
    values.push_back(solution.value({sample.x[i], sample.y[i], sample.z[i]}, sample.t[i], parameters));
  return values;
}

// The coordinate that varies over a sample; of a single place, time.
const std::vector<double>& abscissa(const Sample& sample) {
  for (const auto* axis : {&sample.x, &sample.y, &sample.z})
    if (std::any_of(axis->begin(), axis->end(), [&](double one) { return one != axis->front(); })) return *axis;
  return sample.t;
}

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const double slack = 1e-9 * (x.back() - x.front());
  if (at < x.front() - slack || at > x.back() + slack)
    throw base::RunError(
        fmt::format("the reference reaches from {:g} to {:g} and is needed at {:g}", x.front(), x.back(), at));
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const auto j = std::clamp<std::size_t>(std::size_t(above - x.begin()), 1, x.size() - 1);
  const double part = (at - x[j - 1]) / (x[j] - x[j - 1]);
  return y[j - 1] + part * (y[j] - y[j - 1]);
}

std::vector<double> by_table(const scene::StudyReference& reference, const Task& task, const Sample& sample) {
  const auto& file = reference.tables.size() == 1 ? reference.tables.front() : reference.tables.at(task.level);
  const auto [x, y] = read_columns(file, reference.column);
  const double factor = reference.value ? resolved(*reference.value, task) : 1.0;
  std::vector<double> values;
  for (const double at : abscissa(sample)) values.push_back(factor * interpolated(x, y, at));
  return values;
}

bool same_places(const Sample& a, const Sample& b) {
  const auto near = [](const std::vector<double>& p, const std::vector<double>& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](double one, double other) {
      return std::abs(one - other) <= 1e-9 * std::max(std::abs(one), std::abs(other));
    });
  };
  return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z) && near(a.t, b.t);
}

}  // namespace

std::vector<double> at_places(const Sample& other, const Sample& sample) {
  if (same_places(other, sample)) return other.value;
  const auto& x = abscissa(other);
  if (!std::is_sorted(x.begin(), x.end(), std::less_equal<>()))
    throw base::RunError("two runs cannot be compared: their particles lie at different places; compare a profile");
  std::vector<double> values;
  for (const double at : abscissa(sample))
    values.push_back(interpolated(x, other.value, std::clamp(at, x.front(), x.back())));
  return values;
}

std::vector<double> reference_values(const scene::Study& study, const scene::StudyQuantity& quantity, const Task& task,
                                     const Sample& sample, const Others& others) {
  const auto& reference = quantity.reference;
  switch (reference.type) {
    case Type::formula:
      return by_formula(reference, task, sample);
    case Type::table:
      return by_table(reference, task, sample);
    case Type::value:
      return std::vector<double>(sample.size(), resolved(*reference.value, task));
    case Type::method: {
      const auto level = reference.finest ? study.levels.size() - 1 : task.level;
      const auto* other = others(reference.method.value_or(task.method), level);
      return other ? at_places(*other, sample) : std::vector<double>{};
    }
  }
  return {};
}

}  // namespace shmoo::run::study
