#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>

#include "run/explain/report.hpp"
#include "run/progress_bar.hpp"
#include "scene/well.hpp"

namespace shmoo::run {
namespace {

using Out = std::back_insert_iterator<std::string>;

void say_head(const Report& report, Out out) {
  const auto& [scene, decisions, numbers] = report.decided;
  fmt::format_to(out, "{} ({})\n", scene.title.empty() ? "(no title)" : scene.title, scene.file);
  if (scene::well_mixed(scene)) {
    fmt::format_to(out, "well mixed, {} compartments, {} species, {} reactions, {} events\n", scene.compartments.size(),
                   scene.species.size(), scene.reactions.size(), scene.events.size());
    return;
  }
  fmt::format_to(out, "{}-D, {} voxels", scene.dimension, numbers.voxels);
  if (numbers.particles > numbers.voxels)
    fmt::format_to(out, " and {} particles beyond the sides", numbers.particles - numbers.voxels);
  fmt::format_to(out, ", spacing {:.4g} m, voxel {:.4g} m^3, {} species, {} reactions\n", numbers.spacing,
                 numbers.voxel, scene.species.size(), scene.reactions.size());
}

void say_decisions(const Report& report, Out out) {
  fmt::format_to(out, "decisions\n");
  for (const auto& one : report.decided.decisions) {
    fmt::format_to(out, "  {:<28} {:<13} {}\n", one.key, one.value, one.automatic ? "auto" : "as the model says");
    fmt::format_to(out, "      {}\n", one.reason);
    if (std::isfinite(one.number)) {
      fmt::format_to(out, "      looked at {} = {:.3g} (threshold {:g}; {})\n", one.looked_at, one.number,
                     one.threshold, one.source);
    }
    if (!one.by_rule.empty()) fmt::format_to(out, "      the rule would say {}\n", one.by_rule);
    if (!one.without.empty())
      fmt::format_to(out, "      {}: {}\n", one.value == "on" ? "left out, it would neglect" : "neglected",
                     one.without);
    if (!one.warning.empty()) fmt::format_to(out, "      WARNING: {}\n", one.warning);
  }
}

void say_numbers(const Report& report, Out out) {
  fmt::format_to(out, "numbers\n");
  for (const auto& one : report.numbers)
    fmt::format_to(out, "  {:<34} {:>11.4g} {:<5} {}\n", one.name, one.value, one.unit, one.meaning);
}

void say_limits(const Report& report, Out out) {
  fmt::format_to(out, "limits\n");
  for (const auto& one : report.limits) {
    const auto standing = one.standing();
    fmt::format_to(out, "  {:<7} {:<44} {:>9.3g} (well up to {:g}{})\n", word(standing), one.name, one.value, one.ok,
                   std::isfinite(one.refuse) ? fmt::format(", refused beyond {:g}", one.refuse) : "");
    fmt::format_to(out, "          {}\n", one.meaning);
    if (standing != coupling::Standing::ok) fmt::format_to(out, "          {} [{}]\n", one.suggestion, one.source);
  }
}

void say_derived(const Report& report, Out out) {
  fmt::format_to(out, "derived\n");
  for (const auto& one : report.derived)
    fmt::format_to(out, "  {:<34} {:>11.4g} {:<5} {}\n", one.name, one.value, one.unit, one.why);
}

void say_costs(const coupling::FlowCosts& flow, Out out) {
  fmt::format_to(out, "cost of the flow, CPU time on one thread\n");
  fmt::format_to(
      out,
      "  a step {:.3g} s ({:.3g} particle-steps a second); listing pairs {:.3g} s, {:.2g} times a step at full speed\n",
      flow.step_seconds, double(flow.particles) / flow.step_seconds, flow.build_seconds, flow.builds_per_step);
  fmt::format_to(out, "  columns {:.4g} MB, pairs {:.4g} MB, {:.2g} times as fast on all threads\n",
                 1e-6 * double(flow.column_bytes), 1e-6 * double(flow.row_bytes), flow.speedup);
  fmt::format_to(out, "  {:<20} {:>7} {:>11} {:>10} {:>11} {:>11}  {}\n", "present effect", "share", "s a step",
                 "memory", "step limit", "step without", "columns");
  for (const auto& one : flow.effects) {
    const bool rules = one.step_limit <= flow.step;
    fmt::format_to(out, "  {:<20} {:>5.1f} % {:>11.3g} {:>7.3g} MB {:>11} {:>11.3g}  {}{}\n", one.name, 100 * one.share,
                   one.seconds, 1e-6 * double(one.bytes),
                   std::isfinite(one.step_limit) ? fmt::format("{:.3g} s", one.step_limit) : "-", one.step_without,
                   fmt::join(one.columns, ", "), rules ? " (it rules the step)" : "");
  }
}

void say_forecast(const Forecast& one, const scene::Scene& scene, Out out) {
  fmt::format_to(out, "forecast (measured: {})\n", one.how);
  if (one.flow_steps > 0.0) {
    fmt::format_to(out, "  flow          {:.4g} steps to {:.4g} s{}\n", one.flow_steps, one.flow_time,
                   one.steady ? ", when it should be steady; from there it is carried" : "");
  }
  fmt::format_to(out,
                 "  CPU time      {:.3g} s = {:.2g} s to start, {:.3g} s for what all realisations share, {:.3g} s for "
                 "their jumps, "
                 "{} x {:.3g} s\n",
                 one.cpu_seconds, one.start_seconds, one.shared_seconds, one.once_seconds, scene.run.realisations,
                 one.realisation_seconds);
  fmt::format_to(out, "  time          {} on {} thread{}\n", duration_text(one.wall_seconds), one.threads,
                 one.threads == 1 ? "" : "s");
  fmt::format_to(out, "  memory        {:.3g} MB\n", 1e-6 * double(one.bytes));
  for (const auto& [part, bytes] : one.memory)
    fmt::format_to(out, "    {:<44} {:>9.3g} MB\n", part, 1e-6 * double(bytes));
}

}  // namespace

std::string as_text(const Report& report) {
  std::string text;
  const Out out(text);
  say_head(report, out);
  say_decisions(report, out);
  say_numbers(report, out);
  say_limits(report, out);
  say_derived(report, out);
  if (report.flow) say_costs(*report.flow, out);
  if (report.forecast) say_forecast(*report.forecast, report.decided.scene, out);
  return text;
}

}  // namespace shmoo::run
