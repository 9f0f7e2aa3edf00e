#include <fmt/format.h>

#include "run/verify/shooting_range.hpp"

namespace shmoo::run::verify {
namespace {

using base::Vec;

constexpr double edge = 0.3;  // [m] of the cube, whose middle is the origin: twelve particles

std::string cube(const std::string& sides, const std::string& motion, const std::string& shape) {
  return fmt::format(R"(title = "A hard case"
dimension = 3
[domain]
size = ["{0} m", "{0} m", "{0} m"]
origin = ["{1} m", "{1} m", "{1} m"]
spacing = "{2} m"
boundary = {{ {3} }}
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.01 Pa s"
[materials.plate]
type = "wall"
{4}
[[region]]
material = "plate"
{5}
[flow]
reference_speed = "1 m/s"
[effects]
flow = true
[numerics]
reach = 2
[run]
until = "1 s"
)",
                     edge, -0.5 * edge, shot_spacing, sides, motion, shape);
}

std::string box(const Vec<3>& lower, const Vec<3>& upper) {
  return fmt::format(
      "shape = \"box\"\nlower = [\"{} m\", \"{} m\", \"{} m\"]\nupper = [\"{} m\", \"{} m\", \"{} m\"]\n", lower[0],
      lower[1], lower[2], upper[0], upper[1], upper[2]);
}

const std::string walls = R"(x = "wall", y = "wall", z = "wall")";
const std::string center = "center = [\"0 m\", \"0 m\", \"0 m\"]\n";

// A plate across a channel that is closed to a ring.
Range<3> plate(int layers, double speed) {
  const double width = layers * shot_spacing;
  const auto lap = [=](const Vec<3>& x, double t) {
    const double from = (x[0] - speed * t) / edge;
    return from - std::floor(from);
  };
  const std::string motion = speed == 0.0 ? "" : fmt::format("velocity = [\"{} m/s\", \"0 m/s\", \"0 m/s\"]", speed);
  return {fmt::format("in space, a plate of {} layer{}{}", layers, layers > 1 ? "s" : "",
                      speed == 0.0 ? "" : " that moves"),
          cube(R"(x = "periodic", y = "wall", z = "periodic")", motion,
               box({0.0, -0.5 * edge, -0.5 * edge}, {width, 0.5 * edge, 0.5 * edge})),
          [=](const Vec<3>& x, double t) { return std::min(edge * lap(x, t), width - edge * lap(x, t)); }, lap};
}

Range<3> ball(const char* name, double radius) {
  return {name, cube(walls, "", "shape = \"ball\"\n" + center + fmt::format("radius = \"{} m\"\n", radius)),
          [=](const Vec<3>& x, double) { return radius - x.norm(); }};
}

// Fluid inside and outside of a shell of one layer.
Range<3> shell() {
  constexpr double inner = 0.09, outer = inner + shot_spacing;
  return {
      "a shell of one layer",
      cube(walls, "", "shape = \"shell\"\n" + center + fmt::format("radius = [\"{} m\", \"{} m\"]\n", inner, outer)),
      [=](const Vec<3>& x, double) { return std::min(x.norm() - inner, outer - x.norm()); },
      [=](const Vec<3>& x, double) { return x.norm() < 0.5 * (inner + outer) ? 0.0 : 1.0; }};
}

// A cone within a wall, open at both ends to a periodic side: 3 to 5 particles across.
Range<3> funnel() {
  constexpr double narrow = 0.06, wide = 0.12;
  const auto radius = [=](double x) { return narrow + (wide - narrow) * std::abs(x) / (0.5 * edge); };
  return {"a funnel that narrows and widens",
          cube(R"(x = "periodic", y = "wall", z = "wall")", "",
               fmt::format("shape = \"revolved\"\ncorners = [[\"{0} m\", \"{1} m\"], [\"0 m\", \"{2} m\"], [\"{3} m\", "
                           "\"{1} m\"], [\"{3} m\", \"0.3 m\"], [\"{0} m\", \"0.3 m\"]]\n",
                           -0.5 * edge, wide, narrow, 0.5 * edge)),
          [=](const Vec<3>& x, double) {
            const double steep = (wide - narrow) / (0.5 * edge);
            return (std::hypot(x[1], x[2]) - radius(x[0])) / std::hypot(1.0, steep);
          }};
}

// One layer thick, turning twice a second: its ends run at 0.13 of the speed of sound.
Range<3> paddle() {
  const double w = 4.0 * std::numbers::pi;
  constexpr double length = 0.1, half = 0.5 * shot_spacing;
  return {"in space, a paddle of one layer that turns",
          cube(R"(x = "periodic", y = "periodic", z = "periodic")",
               fmt::format("angular_velocity = [\"0 1/s\", \"0 1/s\", \"{} 1/s\"]\n{}", w, center),
               box({-length, -half, -length}, {length, half, length})),
          [=](const Vec<3>& x, double t) {
            const double along = x[0] * std::cos(w * t) + x[1] * std::sin(w * t);
            const double beside = x[1] * std::cos(w * t) - x[0] * std::sin(w * t);
            return std::min({length - std::abs(along), half - std::abs(beside), length - std::abs(x[2])});
          }};
}

}  // namespace

std::vector<Range<3>> ranges_in_space() {
  return {plate(1, 0.0),
          plate(3, 0.0),
          plate(1, 2.0),
          ball("a ball in a cube", 0.09),
          ball("a ball of four particles across in a cube", 0.05),
          shell(),
          funnel(),
          paddle()};
}

}  // namespace shmoo::run::verify
