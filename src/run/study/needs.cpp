#include "run/study/needs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace shmoo::run::study {
namespace {

double square(double x) { return x * x; }

std::optional<Need> need_of(const Row& row, double wanted) {
  Need need{
      .wanted = wanted, .cpu_seconds = row.cpu_seconds, .method = row.method, .level = row.level, .random = row.random};
  if (!std::isfinite(row.error)) return std::nullopt;
  const double chance = std::isfinite(row.predicted) ? row.predicted : row.measured;
  if (!row.random || !std::isfinite(chance)) {
    need.realisations = row.realisations;
    return row.error <= wanted ? std::optional(need) : std::nullopt;
  }
  const double left = square(wanted) - square(row.systematic);
  if (left <= 0.0) return std::nullopt;
  const double n = double(row.realisations), wanted_n = std::ceil(n * square(chance) / left);
  if (wanted_n > 1e9) return std::nullopt;
  need.realisations = std::max<std::size_t>(1, std::size_t(wanted_n));
  const double shared = std::max(0.0, row.cpu_seconds - n * row.cpu_per_realisation);
  need.cpu_seconds = shared + double(need.realisations) * row.cpu_per_realisation;
  return need;
}

}  // namespace

void mark_pareto(std::vector<Row>& rows) {
  for (auto& row : rows) {
    row.pareto = std::isfinite(row.error) && std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
                   return other.cpu_seconds <= row.cpu_seconds && other.error <= row.error &&
                          (other.cpu_seconds < row.cpu_seconds || other.error < row.error);
                 });
  }
}

std::vector<Need> needs(const scene::Study& study, const std::vector<Row>& rows) {
  std::vector<Need> all;
  for (const double wanted : study.wanted)
    for (const auto& method : study.methods) {
      std::optional<Need> best;
      for (const auto& row : rows) {
        if (row.method != method.name) continue;
        const auto need = need_of(row, wanted);
        if (need && (!best || need->cpu_seconds < best->cpu_seconds)) best = need;
      }
      if (best) all.push_back(*best);
    }
  return all;
}

}  // namespace shmoo::run::study
