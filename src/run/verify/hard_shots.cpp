#include <fmt/format.h>

#include "run/verify/shooting_range.hpp"

namespace shmoo::run::verify {
namespace {

using base::Vec;

std::string range_model(const std::string& sides, const std::string& wall) {
  return square(fmt::format("{} m", shot_spacing), "0.01 Pa s", sides,
                wall + "[flow]\nreference_speed = \"1 m/s\"\n[effects]\nflow = true\n");
}

std::string box_of_wall(double left, double width, double bottom, double height, const std::string& motion) {
  return fmt::format(
      "[materials.plate]\ntype = \"wall\"\n{}[[region]]\nmaterial = \"plate\"\nshape = \"box\"\n"
      "lower = [\"{} m\", \"{} m\"]\nupper = [\"{} m\", \"{} m\"]\n",
      motion, left, bottom, left + width, bottom + height);
}

// A plate across a channel that is closed to a ring.
Range<2> plate(int layers, double speed) {
  const double width = layers * shot_spacing;
  const auto lap = [=](const Vec<2>& x, double t) {
    const double from = x[0] - 0.5 - speed * t;
    return from - std::floor(from);
  };
  const std::string motion = speed == 0.0 ? "" : fmt::format("velocity = [\"{} m/s\", \"0 m/s\"]\n", speed);
  return {fmt::format("a plate of {} layer{}{}", layers, layers > 1 ? "s" : "", speed == 0.0 ? "" : " that moves"),
          range_model(R"({ x = "periodic", y = "wall" })", box_of_wall(0.5, width, 0.0, 1.0, motion)),
          [=](const Vec<2>& x, double t) { return std::min(lap(x, t), width - lap(x, t)); }, lap};
}

Range<2> ball(const char* name, double radius) {
  return {name,
          range_model(R"({ x = "wall", y = "wall" })",
                      fmt::format("[materials.plate]\ntype = \"wall\"\n[[region]]\nmaterial = \"plate\"\n"
                                  "shape = \"disk\"\ncenter = [\"0.5 m\", \"0.5 m\"]\nradius = \"{} m\"\n",
                                  radius)),
          [=](const Vec<2>& x, double) { return radius - (x - Vec<2>(0.5, 0.5)).norm(); }};
}

// One layer thick, turning once in two seconds: its ends run at 0.13 of the speed of sound.
Range<2> paddle() {
  const double w = std::numbers::pi;
  return {"a paddle of one layer that turns",
          range_model(periodic, box_of_wall(0.1, 0.8, 0.4875, shot_spacing,
                                            fmt::format("angular_velocity = \"{} 1/s\"\n"
                                                        "center = [\"0.5 m\", \"0.5 m\"]\n",
                                                        w))),
          [=](const Vec<2>& x, double t) {
            const Vec<2> r = x - Vec<2>(0.5, 0.5), along(std::cos(w * t), std::sin(w * t));
            return std::min(0.4 - std::abs(r.dot(along)),
                            0.5 * shot_spacing - std::abs(r.dot(Vec<2>(-along[1], along[0]))));
          }};
}

std::vector<Range<2>> ranges_in_the_plane() {
  return {plate(1, 0.0),
          plate(2, 0.0),
          plate(3, 0.0),
          plate(1, 2.0),
          plate(3, 2.0),
          ball("a ball in a box", 0.2),
          ball("a ball of four particles across", 0.05),
          paddle()};
}

std::vector<Finding> million() {
  auto findings = under_fire(ranges_in_the_plane(), 500'000);
  for (auto& finding : under_fire(ranges_in_space(), 500'000)) findings.push_back(std::move(finding));
  return findings;
}

}  // namespace

std::vector<Case> hard_shots() {
  return {{"shots-at-walls", "10^5 hits at Mach 1 on thin, curved, moving and cornered walls",
           [] { return under_fire(ranges_in_the_plane(), 100'000); }},
          {"shots-in-space", "10^5 hits at Mach 1 on such walls in three dimensions",
           [] { return under_fire(ranges_in_space(), 100'000); }},
          {"million-hits", "10^6 hits at Mach 1 on the walls of both", million, true}};
}

}  // namespace shmoo::run::verify
