// Zones of a finer spacing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/build.hpp"
#include "scene/refinement.hpp"

namespace shmoo::scene {
namespace {

constexpr double least_width = 2.0;      // [reaches of the coarse kernel] of a box
constexpr double least_clearance = 2.0;  // [reaches] from open sides, from parallel periodic ones and between boxes
constexpr double tolerance = 1e-6;       // [spacings]

const BoxShape& box_of(const Refinement& refinement) { return std::get<BoxShape>(refinement.shape->form); }

void check_spacing(const Section& section, const Scene& scene, double spacing) {
  const double coarse = scene.domain.spacing;
  if (coarse == 0 || spacing == 0 || std::abs(2 * spacing / coarse - 1) < 1e-9) return;
  section.error("spacing",
                fmt::format("{:.6g} m is not half of domain.spacing; a particle that passes into the zone is "
                            "split into four, so write {:.6g} m",
                            spacing, 0.5 * coarse));
}

// One axis of a box: inside the domain, wide enough, and with room for the coarse particles where these must be.
void check_axis(const Section& section, const Scene& scene, const BoxShape& box, std::size_t a) {
  const double lower = box.lower[a] - scene.domain.lower[a], upper = scene.domain.upper[a] - box.upper[a];
  const double spacing = scene.domain.spacing, reach = scene.numerics.reach * spacing, tiny = tolerance * spacing;
  if (lower < -tiny || upper < -tiny)
    return section.error(lower < -tiny ? "lower" : "upper",
                         fmt::format("lies outside the domain along {}; keep the box inside", axis_names[a]));
  const double width = box.upper[a] - box.lower[a];
  if (width < least_width * reach - tiny)
    return section.error("upper",
                         fmt::format("the box is {:.6g} m wide along {}; the kernel's reach changes across its "
                                     "border, so make it at least {:.6g} m",
                                     width, axis_names[a], least_width * reach));
  for (std::size_t side = 0; side < 2; ++side) {
    const double gap = side == 0 ? lower : upper;
    const auto type = scene.domain.sides[a][side].type;
    const bool spans = std::max(lower, upper) <= tiny;
    if (!is_open(type) && (type != SideType::periodic || spans)) continue;
    if (gap >= least_clearance * reach - tiny) continue;
    return section.error(side == 0 ? "lower" : "upper",
                         fmt::format("is {:.6g} m from {} side along {}; keep the box at least {:.6g} m from it{}", gap,
                                     is_open(type) ? "an open" : "a periodic", axis_names[a], least_clearance * reach,
                                     is_open(type) ? "" : ", or let it span the axis"));
  }
}

bool apart(const BoxShape& one, const BoxShape& other, double distance, int dimension) {
  for (std::size_t a = 0; a < std::size_t(dimension); ++a)
    if (one.lower[a] - other.upper[a] >= distance || other.lower[a] - one.upper[a] >= distance) return true;
  return false;
}

void check_box(const Section& section, const Scene& scene, const Refinement& refinement) {
  const auto& box = box_of(refinement);
  for (std::size_t a = 0; a < std::size_t(scene.dimension); ++a) check_axis(section, scene, box, a);
  const double distance = least_clearance * scene.numerics.reach * scene.domain.spacing;
  for (const auto& other : scene.domain.refinements) {
    if (apart(box, box_of(other), (1 - tolerance) * distance, scene.dimension)) continue;
    return section.error(
        fmt::format("lies within {:.6g} m of another refinement; keep them apart, or make them one", distance));
  }
}

}  // namespace

void build_refinements(const Section& root, Scene& scene) {
  for (const auto& section : root.sections("refinement")) {
    Refinement refinement{build_shape(section, scene.dimension), section.quantity("spacing").value_or(0),
                          section.where()};
    check_spacing(section, scene, refinement.spacing);
    if (!refinement.shape) continue;
    if (!std::holds_alternative<BoxShape>(refinement.shape->form)) {
      section.error("shape", "only a box can have a spacing of its own so far; write \"box\"");
      continue;
    }
    if (scene.domain.spacing > 0) check_box(section, scene, refinement);
    scene.domain.refinements.push_back(std::move(refinement));
    const char* misfit = scene.domain.refinements.size() == 1 ? misfit_of_refinements(scene) : nullptr;
    if (misfit) section.error(misfit);
  }
}

}  // namespace shmoo::scene
