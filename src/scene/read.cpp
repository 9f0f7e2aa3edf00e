#include "scene/read.hpp"

#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/document.hpp"
#include "scene/schema.hpp"

namespace shmoo::scene {
namespace {

// 1, 2 or 3; 0 where the file does not say so.
int dimension_of(const toml::table& root) {
  const auto* node = root.get("dimension");
  const auto value = node && node->is_integer() ? node->value_or(std::int64_t{0}) : 0;
  return value >= 1 && value <= 3 ? static_cast<int>(value) : 0;
}

void build(const Section& root, Draft& draft) {
  build_run(root, draft);
  if (draft.well) {
    build_well(root, draft);
  } else {
    build_materials(root, draft);
    build_domain(root, draft);
    build_mechanics(root, draft);
  }
  build_numerics(root, draft);
  build_regions(root, draft);
  build_parameters(root, draft);
  build_species(root, draft);
  if (!draft.well) build_depth(root, draft);
  build_definitions(root, draft);
  build_initials(root, draft);
  build_reactions(root, draft);
  build_events(root, draft);
  build_boundaries(root, draft);
  if (!draft.well) build_openings(root, draft);
  build_inflows(root, draft);
  build_flow(root, draft);
  build_solids(root, draft);
  build_wall(root, draft);
  build_effects(root, draft);
  if (!draft.well) build_refinements(root, draft);
  build_observables(root, draft);
  build_record(root, draft);
}

}  // namespace

Scene read_scene_text(const std::string& text, const std::string& file, const Overrides& overrides) {
  Document document = parse_document(text, file, overrides);
  Report report(file);
  const int dimension = dimension_of(document.root);
  const bool well = document.root.contains("compartments");
  Checker(report, dimension, well).check_table(document.root, table(""), "");
  if (dimension == 0) report.finish();  // what depends on the number of axes cannot be judged
  Draft draft;
  draft.file = file;
  draft.text = std::move(document.text);
  draft.dimension = well ? 0 : dimension;
  draft.well = well;
  const Section root(document.root, "", report);
  draft.title = root.text("title").value_or("");
  build(root, draft);
  report.finish();
  return std::move(static_cast<Scene&>(draft));
}

Scene read_scene(const std::string& file, const Overrides& overrides) {
  return read_scene_text(read_bytes(file), file, overrides);
}

}  // namespace shmoo::scene
