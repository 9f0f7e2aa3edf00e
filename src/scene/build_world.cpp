// Materials, the domain, regions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

constexpr std::size_t most_materials = 1000;
constexpr double most_particles = 2e8;
constexpr std::size_t longest_name = 64;  // bytes
constexpr std::string_view nothing = "nothing";

std::string material_name_problem(const std::string& name) {
  const bool control =
      std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (name.empty() || name.size() > longest_name || control || name.find('/') != std::string::npos)
    return "a material's name has 1 to 64 bytes, no '/' and no control characters";
  const bool side = name.size() == 5 && axis_names.find(name[0]) != std::string_view::npos &&
                    (name.ends_with("_min") || name.ends_with("_max"));
  if (side || name == nothing || name == "expression")
    return fmt::format("'{}' has a meaning of its own; call the material something else", name);
  return "";
}

// The motion that `prefix`velocity and `prefix`angular_velocity give, if any.
std::optional<RigidMotion> motion_of(const Section& section, const std::string& prefix, int dimension) {
  const std::string straight = prefix + "velocity", turning = prefix + "angular_velocity";
  if (!section.has(straight) && !section.has(turning)) return std::nullopt;
  RigidMotion motion;
  motion.velocity = section.point(straight).value_or(Point{});
  motion.center = section.point("center").value_or(Point{});
  if (const auto* node = section.good(turning)) {
    if (dimension == 1)
      section.error(turning, "nothing turns in one dimension");
    else if (node->is_array() != (dimension == 3))
      section.error(turning, dimension == 3 ? "expected a list of 3 in a scene of three dimensions"
                                            : "expected one quantity, not a list, in a scene of two dimensions");
    else
      motion.angular_velocity = dimension == 3 ? point_of(*node) : Point{0, 0, quantity_of(*node)};
    if (!section.has("center")) section.error(turning, "needs 'center', the point that it turns round");
  }
  return motion;
}

// What makes the motion of a wall more than rigid, and its end.
void read_strain(const Section& section, int dimension, std::optional<RigidMotion>& motion) {
  if (section.has("strain_rate")) {
    const auto rates = section.quantities("strain_rate");
    if (int(rates.size()) != dimension)
      return section.error("strain_rate", fmt::format("needs one rate for each of the {} axes", dimension));
    if (section.has("angular_velocity"))
      return section.error("strain_rate", "a wall that turns cannot be strained; remove one of them");
    if (!section.has("center"))
      return section.error("strain_rate", "needs 'center', the point that it moves away from");
    if (!motion) motion = RigidMotion{};
    motion->center = section.point("center").value_or(Point{});
    std::copy(rates.begin(), rates.end(), motion->strain_rate.begin());
  }
  if (!section.has("moves_until")) return;
  if (!motion) return section.error("moves_until", "this wall does not move; give a velocity, or remove it");
  motion->until = section.quantity("moves_until").value_or(motion->until);
}

void refuse_keys(const Section& section, std::initializer_list<const char*> keys, const std::string& why) {
  for (const char* key : keys)
    if (section.has(key)) section.error(key, why);
}

Material material_of(const std::string& name, const Section& section, int dimension) {
  Material material;
  material.name = name;
  if (const auto problem = material_name_problem(name); !problem.empty()) section.error(problem);
  const auto type = section.text("type");
  if (type == "wall")
    material.type = MaterialType::wall;
  else if (type == "still")
    material.type = MaterialType::still;
  else if (type == "solid")
    material.type = MaterialType::solid;
  if (type && type != "fluid") refuse_keys(section, {"viscosity", "bulk_viscosity"}, "only a fluid has it; remove it");
  if (type && type != "fluid" && type != "solid")
    refuse_keys(section, {"density"}, "only a fluid or a solid has it; remove it");
  if (type && type != "wall" && type != "solid")
    refuse_keys(section, {"velocity", "angular_velocity", "center"}, "only a wall or a solid has it; remove it");
  if (type && type != "wall")
    refuse_keys(section, {"surface_velocity", "surface_angular_velocity", "strain_rate", "moves_until"},
                "only a wall has it; remove it");
  material.density = section.quantity("density").value_or(0);
  material.viscosity = section.quantity("viscosity").value_or(0);
  material.bulk_viscosity = section.quantity("bulk_viscosity").value_or(0);
  if (type == "wall" || type == "solid") material.motion = motion_of(section, "", dimension);
  if (type == "wall") read_strain(section, dimension, material.motion);
  if (type == "wall") material.surface_motion = motion_of(section, "surface_", dimension);
  return material;
}

void check_extent(const Section& domain, const Scene& scene) {
  const auto size = domain.point("size");
  const double spacing = scene.domain.spacing;
  if (!size || spacing == 0) return;
  double particles = 1;
  for (int axis = 0; axis < scene.dimension; ++axis) {
    const double length = (*size)[static_cast<std::size_t>(axis)];
    if (spacing > length) {
      domain.error("spacing",
                   fmt::format("{:.6g} m is larger than the domain's {:.6g} m along {}; choose a smaller spacing",
                               spacing, length, axis_names[static_cast<std::size_t>(axis)]));
      return;
    }
    particles *= length / spacing;
  }
  if (particles > most_particles)
    domain.error("spacing",
                 fmt::format("this makes {:.3g} particles; at most {:.3g} are allowed; choose a larger spacing",
                             particles, most_particles));
}

void build_fill(const Section& domain, Scene& scene) {
  const auto fills = [](const Material& one) {
    return one.type == MaterialType::fluid || one.type == MaterialType::still;
  };
  const bool bare = has_solids(scene) && std::none_of(scene.materials.begin(), scene.materials.end(), fills);
  if (domain.has("material")) {
    const auto name = domain.text("material");
    if (name && *name != nothing)
      scene.domain.material = material_index(scene, *name, domain, "material", *domain.find("material"));
    return;
  }
  if (bare) return;
  for (const MaterialType type : {MaterialType::fluid, MaterialType::still}) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      if (scene.materials[i].type == type) candidates.push_back(static_cast<int>(i));
    if (candidates.empty()) continue;
    if (candidates.size() == 1) {
      scene.domain.material = candidates.front();
      return;
    }
    break;
  }
  domain.error("material",
               "missing; there is not just one fluid (or, without fluids, one still material), so say which material "
               "fills what no "
               "region covers, or \"nothing\"");
}

}  // namespace

int material_index(const Scene& scene, const std::string& name, const Section& section, std::string_view key,
                   const toml::node& at) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name == name) return static_cast<int>(i);
    names.push_back(scene.materials[i].name);
  }
  section.error(at, key,
                fmt::format("no material is called {}{}", quoted(name),
                            suggestion(name, names, fmt::format("materials: {}", listed(names)))));
  return -1;
}

std::vector<int> material_list(const Scene& scene, const Section& section, std::string_view key, bool& good) {
  std::vector<int> list;
  for (const auto& [name, node] : section.names(key)) {
    const int index = material_index(scene, name, section, key, *node);
    if (index < 0)
      good = false;
    else if (std::find(list.begin(), list.end(), index) == list.end())
      list.push_back(index);
  }
  if (section.has(key) && list.empty()) good = false;
  std::sort(list.begin(), list.end());
  return list;
}

void build_materials(const Section& root, Scene& scene) {
  for (const auto& [name, section] : root.named_sections("materials"))
    scene.materials.push_back(material_of(name, section, scene.dimension));
  const auto given = root.section("materials");
  if (given && given->table().size() > most_materials)
    root.error("materials", fmt::format("there are {}; at most {} are allowed", given->table().size(), most_materials));
  if (given && given->table().empty()) root.error("materials", "there must be at least one [materials.NAME]");
}

void build_domain(const Section& root, Scene& scene) {
  const auto domain = root.section("domain");
  if (!domain) return;
  scene.domain.lower = domain->point("origin").value_or(Point{});
  const Point size = domain->point("size").value_or(Point{});
  for (std::size_t axis = 0; axis < 3; ++axis) scene.domain.upper[axis] = scene.domain.lower[axis] + size[axis];
  scene.domain.spacing = domain->quantity("spacing").value_or(0);
  scene.domain.jitter = domain->number("jitter").value_or(0);
  build_sides(*domain, scene);
  check_extent(*domain, scene);
  if (!scene.materials.empty()) build_fill(*domain, scene);
}

void build_regions(const Section& root, Scene& scene) {
  for (const auto& section : root.sections("region")) {
    Region region{build_shape(section, scene.dimension), 0, section.where()};
    if (const auto name = section.text("material"))
      region.material = material_index(scene, *name, section, "material", *section.find("material"));
    if (region.shape && region.material >= 0) scene.regions.push_back(std::move(region));
  }
}

void build_depth(const Section& root, Scene& scene) {
  const bool fluid = std::any_of(scene.materials.begin(), scene.materials.end(),
                                 [](const Material& material) { return material.type == MaterialType::fluid; });
  const std::string right = scene.axisymmetric     ? ""
                            : scene.dimension == 2 ? "depth"
                            : scene.dimension == 1 ? "cross_section"
                                                   : "";
  for (const std::string key : {"depth", "cross_section"})
    if (key != right && root.has(key))
      root.error(key, fmt::format("{} of dimension {} does not have it; {}",
                                  scene.axisymmetric ? "an axisymmetric scene" : "a scene", scene.dimension,
                                  right.empty() ? "remove it" : fmt::format("write '{}'", right)));
  scene.depth = right.empty() ? 1 : root.quantity(right).value_or(1);
  if (!right.empty() && !root.has(right) && (fluid || has_solids(scene) || !scene.species.empty()))
    root.error(right, fmt::format(
                          "missing; where there are species, a fluid or a solid, a scene of dimension {} needs it: {}",
                          scene.dimension,
                          base::expectation(scene.dimension == 2 ? base::dimensions::length : base::dimensions::area)));
}

}  // namespace shmoo::scene
