#include <fmt/format.h>

#include <array>
#include <utility>

#include "scene/build.hpp"

namespace shmoo::scene {
namespace {

ShapePointer made(auto&& form) { return std::make_shared<const Shape>(Shape{std::forward<decltype(form)>(form)}); }

ShapePointer build_box(const Section& section, int dimension) {
  const auto lower = section.point("lower"), upper = section.point("upper");
  if (!lower || !upper) return nullptr;
  for (int axis = 0; axis < dimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if ((*lower)[a] < (*upper)[a]) continue;
    section.error("upper", fmt::format("must lie above 'lower' on every axis; along {} it does not", axis_names[a]));
    return nullptr;
  }
  return made(BoxShape{*lower, *upper});
}

// Which of `diameter` and `radius` is given; empty, with a message, where it is not just one.
std::string_view size_key(const Section& section) {
  const bool diameter = section.has("diameter"), radius = section.has("radius");
  if (diameter && radius)
    section.error("radius", "give either 'diameter' or 'radius', not both");
  else if (!diameter && !radius)
    section.error("diameter", "missing; give 'diameter' or 'radius'");
  if (diameter == radius) return {};
  return diameter ? "diameter" : "radius";
}

ShapePointer build_ball(const Section& section) {
  const auto key = size_key(section);
  const auto center = section.point("center");
  const auto size = key.empty() ? std::nullopt : section.quantity(key);
  if (!center || !size) return nullptr;
  return made(BallShape{*center, key == "radius" ? *size : 0.5 * *size});
}

ShapePointer build_shell(const Section& section) {
  const auto key = size_key(section);
  const auto center = section.point("center");
  const auto sizes = key.empty() ? std::vector<double>{} : section.quantities(key);
  if (!center || sizes.size() != 2) return nullptr;
  if (sizes[0] >= sizes[1]) {
    section.error(key, "the first entry, the inner one, must be smaller than the second");
    return nullptr;
  }
  const double factor = key == "radius" ? 1 : 0.5;
  return made(ShellShape{*center, factor * sizes[0], factor * sizes[1]});
}

ShapePointer build_half_space(const Section& section) {
  const auto point = section.point("point"), normal = section.point("normal");
  if (!point || !normal) return nullptr;
  if (*normal == Point{}) {
    section.error("normal", "must not be 0 on every axis");
    return nullptr;
  }
  return made(HalfSpaceShape{*point, *normal});
}

ShapePointer build_polygon(const Section& section) {
  const auto* corners = section.good("corners");
  if (!corners) return nullptr;
  PolygonShape polygon;
  for (const auto& corner : *corners->as_array()) {
    const Point point = point_of(corner);
    polygon.corners.push_back({point[0], point[1]});
  }
  return made(std::move(polygon));
}

// Corners are places along the x axis and distances from it.
ShapePointer build_revolved(const Section& section) {
  const auto shape = build_polygon(section);
  if (!shape) return nullptr;
  for (const auto& corner : std::get<PolygonShape>(shape->form).corners) {
    if (corner[1] >= 0.0) continue;
    section.error("corners", fmt::format("the second number of a corner is its distance from the x axis, and {:g} m is "
                                         "below 0; give the half of the outline that lies above the axis",
                                         corner[1]));
    return nullptr;
  }
  return shape;
}

ShapePointer build_union(const Section& section, int dimension) {
  UnionShape all;
  bool good = section.good("of") != nullptr;
  for (const auto& part : section.sections("of")) {
    all.parts.push_back(build_shape(part, dimension));
    good = good && all.parts.back();
  }
  return good ? made(std::move(all)) : nullptr;
}

ShapePointer build_difference(const Section& section, int dimension) {
  const auto from = section.section("from"), without = section.section("without");
  if (!from || !without) return nullptr;
  DifferenceShape difference{build_shape(*from, dimension), build_shape(*without, dimension)};
  return difference.from && difference.without ? made(std::move(difference)) : nullptr;
}

}  // namespace

// The checker has limited how deep shapes nest; deeper ones are bad and are not entered.
ShapePointer build_shape(const Section& section, int dimension) {
  const auto name = section.text("shape");
  if (!name || section.report().bad(section.table())) return nullptr;
  if (name == "box") return build_box(section, dimension);
  if (name == "disk" || name == "ball") return build_ball(section);
  if (name == "ring" || name == "shell") return build_shell(section);
  if (name == "half_plane" || name == "half_space") return build_half_space(section);
  if (name == "polygon") return build_polygon(section);
  if (name == "revolved") return build_revolved(section);
  if (name == "union") return build_union(section, dimension);
  return build_difference(section, dimension);
}

}  // namespace shmoo::scene
