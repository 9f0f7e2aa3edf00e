#include <cmath>

#include "run/explain/report.hpp"

namespace shmoo::run {
namespace {

using nlohmann::json;

// JSON has no infinity: such numbers are null.
json number(double value) { return std::isfinite(value) ? json(value) : json(); }

json of(const coupling::Decision& one) {
  return {{"key", one.key},
          {"value", one.value},
          {"auto", one.automatic},
          {"by_rule", one.by_rule.empty() ? one.value : one.by_rule},
          {"number", number(one.number)},
          {"looked_at", one.looked_at},
          {"threshold", number(one.threshold)},
          {"source", one.source},
          {"reason", one.reason},
          {"warning", one.warning},
          {"without", one.without}};
}

json of(const coupling::Limit& one) {
  return {{"name", one.name},
          {"value", number(one.value)},
          {"ok", one.ok},
          {"refuse", number(one.refuse)},
          {"standing", word(one.standing())},
          {"meaning", one.meaning},
          {"suggestion", one.suggestion},
          {"source", one.source}};
}

json of(const Telling& one) {
  return {{"name", one.name}, {"value", number(one.value)}, {"unit", one.unit}, {"meaning", one.meaning}};
}

json of(const coupling::Experiment::Derived& one) {
  return {{"name", one.name}, {"value", number(one.value)}, {"unit", one.unit}, {"why", one.why}};
}

template <class T>
json all(const std::vector<T>& list) {
  json array = json::array();
  for (const auto& one : list) array.push_back(of(one));
  return array;
}

}  // namespace

json as_json(const Report& report) {
  const auto& [scene, decisions, numbers] = report.decided;
  return {{"title", scene.title},           {"file", scene.file},
          {"dimension", scene.dimension},   {"voxels", numbers.voxels},
          {"particles", numbers.particles}, {"spacing", numbers.spacing},
          {"decisions", all(decisions)},    {"numbers", all(report.numbers)},
          {"limits", all(report.limits)},   {"derived", all(report.derived)}};
}

}  // namespace shmoo::run
