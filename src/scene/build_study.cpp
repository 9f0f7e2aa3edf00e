// From a checked study document to a Study.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/exact_solutions.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/document.hpp"
#include "scene/study.hpp"
#include "scene/study_parts.hpp"

namespace shmoo::scene {
namespace {

std::string beside(const std::string& file, const std::string& path) {
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

Overrides overrides_in(const Section& section) {
  Overrides set;
  const auto table = section.section("set");
  if (!table) return set;
  for (const auto& [key, value] : table->table()) {
    std::ostringstream text;
    value.visit([&](const auto& one) { text << one; });
    set.emplace_back(std::string(key.str()), text.str());
  }
  return set;
}

// A name for files, unlike those before it.
std::string file_name(const Section& section, std::set<std::string>& taken, bool plain) {
  const auto name = section.text("name").value_or("");
  if (name.empty()) return name;
  if (plain &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") != std::string::npos)
    section.error("name", fmt::format("{} is no name; use letters, digits, _ and -", scene::quoted(name)));
  else if (!taken.insert(name).second)
    section.error("name", fmt::format("{} is there twice; names must differ", scene::quoted(name)));
  return name;
}

void build_levels(const Section& root, Study& study) {
  std::set<std::string> taken;
  for (const auto& section : root.sections("level"))
    study.levels.push_back({file_name(section, taken, false), overrides_in(section)});
}

std::vector<bool> levels_of(const Section& section, const Study& study) {
  std::vector<bool> run(study.levels.size(), !section.has("levels"));
  std::vector<std::string> names;
  for (const auto& level : study.levels) names.push_back(level.name);
  for (const auto& [name, node] : section.names("levels")) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end())
      run[static_cast<std::size_t>(found - names.begin())] = true;
    else
      section.error(*node, "levels",
                    fmt::format("there is no level {}{}", scene::quoted(name),
                                suggestion(name, names, fmt::format("levels: {}", listed(names)))));
  }
  return run;
}

void build_methods(const Section& root, Study& study) {
  std::set<std::string> taken;
  for (const auto& section : root.sections("method")) {
    StudyMethod method;
    method.name = file_name(section, taken, true);
    method.set = overrides_in(section);
    if (const auto n = section.integer("realisations")) method.realisations = static_cast<std::size_t>(*n);
    method.levels = levels_of(section, study);
    method.repeats = static_cast<std::size_t>(section.integer("repeats").value_or(1));
    study.methods.push_back(std::move(method));
  }
  const auto sections = root.sections("method");
  for (std::size_t m = 0; m < sections.size(); ++m)
    study.methods[m].mean_of = method_index(sections[m], "mean_of", study);
}

// What the model file says before the study changes it, for names and the number of axes.
Scene model_of(const Section& root, Study& study) {
  const auto model = root.text("model");
  if (!model) return {};
  study.model = beside(study.file, *model);
  if (!std::filesystem::is_regular_file(study.model)) {
    root.error("model", fmt::format("there is no file {} beside the study; give the path of a model file",
                                    scene::quoted(*model)));
    return {};
  }
  return read_scene(study.model);
}

}  // namespace

std::optional<std::size_t> method_index(const Section& section, std::string_view key, const Study& study) {
  const auto name = section.text(key);
  if (!name) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& method : study.methods) names.push_back(method.name);
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  section.error(key, fmt::format("there is no method {}{}", scene::quoted(*name),
                                 suggestion(*name, names, fmt::format("methods: {}", listed(names)))));
  return std::nullopt;
}

Study read_study_text(const std::string& text, const std::string& file) {
  const Document document = parse_document(
      text, file, {}, "a study needs at least title, name, model, [[method]], [[level]] and [[quantity]]");
  Report report(file);
  const Section root(document.root, "", report);
  Study study;
  study.file = file;
  const auto* named = root.find("model");
  const Scene scene = named && named->is_string() ? model_of(root, study) : Scene{};
  Checker(report, study.model.empty() ? 0 : scene.dimension).check_table(document.root, table("study"), "");
  study.title = root.text("title").value_or("");
  std::set<std::string> taken;
  study.name = file_name(root, taken, true);
  study.regime = root.text("regime").value_or(study.title);
  study.resolution = root.text("resolution").value_or("domain.spacing");
  study.budget = root.quantity("budget").value_or(600.0);
  if (const auto* wanted = root.good("wanted")) study.wanted = quantities_of(*wanted);
  std::sort(study.wanted.rbegin(), study.wanted.rend());
  build_levels(root, study);
  build_methods(root, study);
  build_quantities(root, scene, study);
  report.finish();
  return study;
}

Study read_study(const std::string& file) { return read_study_text(read_bytes(file, "study"), file); }

}  // namespace shmoo::scene
