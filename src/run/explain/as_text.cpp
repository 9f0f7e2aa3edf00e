#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "run/explain/report.hpp"

namespace shmoo::run {
namespace {

using Out = std::back_insert_iterator<std::string>;

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

}  // namespace

std::string as_text(const Report& report) {
  std::string text;
  const Out out(text);
  const auto& [scene, decisions, numbers] = report.decided;
  fmt::format_to(out, "{} ({})\n{}-D, {} voxels", scene.title.empty() ? "(no title)" : scene.title, scene.file,
                 scene.dimension, numbers.voxels);
  if (numbers.particles > numbers.voxels)
    fmt::format_to(out, " and {} particles beyond the sides", numbers.particles - numbers.voxels);
  fmt::format_to(out, ", spacing {:.4g} m, voxel {:.4g} m^3, {} species, {} reactions\n", numbers.spacing,
                 numbers.voxel, scene.species.size(), scene.reactions.size());
  say_decisions(report, out);
  say_numbers(report, out);
  say_limits(report, out);
  say_derived(report, out);
  return text;
}

}  // namespace shmoo::run
