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

json of(const coupling::EffectCost& one, double step) {
  return {{"name", one.name},
          {"seconds", one.seconds},
          {"share", one.share},
          {"bytes", one.bytes},
          {"columns", one.columns},
          {"step_limit", number(one.step_limit)},
          {"step_without", one.step_without},
          {"rules", one.step_limit <= step}};
}

json of(const coupling::FlowCosts& flow) {
  json effects = json::array();
  for (const auto& one : flow.effects) effects.push_back(of(one, flow.step));
  return {{"particles", flow.particles},
          {"step", flow.step},
          {"step_seconds", flow.step_seconds},
          {"build_seconds", flow.build_seconds},
          {"builds_per_step", flow.builds_per_step},
          {"speedup", flow.speedup},
          {"column_bytes", flow.column_bytes},
          {"row_bytes", flow.row_bytes},
          {"effects", effects}};
}

json of(const Forecast& one) {
  json memory = json::object();
  for (const auto& [part, bytes] : one.memory) memory[part] = bytes;
  return {{"flow_time", one.flow_time},
          {"flow_steps", one.flow_steps},
          {"steady", one.steady},
          {"start_seconds", one.start_seconds},
          {"shared_seconds", one.shared_seconds},
          {"once_seconds", one.once_seconds},
          {"realisation_seconds", one.realisation_seconds},
          {"cpu_seconds", one.cpu_seconds},
          {"wall_seconds", one.wall_seconds},
          {"threads", one.threads},
          {"bytes", one.bytes},
          {"memory", memory},
          {"how", one.how}};
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
  return {{"title", scene.title},
          {"file", scene.file},
          {"dimension", scene.dimension},
          {"voxels", numbers.voxels},
          {"particles", numbers.particles},
          {"spacing", numbers.spacing},
          {"decisions", all(decisions)},
          {"numbers", all(report.numbers)},
          {"limits", all(report.limits)},
          {"derived", all(report.derived)},
          {"flow", report.flow ? of(*report.flow) : json()},
          {"forecast", report.forecast ? of(*report.forecast) : json()}};
}

}  // namespace shmoo::run
