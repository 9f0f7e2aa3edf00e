#include <set>

#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

const std::string swinging =
    "{ x_min = { type = \"inlet\", velocity = [\"U*(0.5 + sin(w*t))\", \"0*U\"] }, "
    "x_max = \"outlet\", y_min = \"wall\", y_max = \"slip\" }";

// A stream past a block whose inlet swings: what entered leaves again through the inlet, and what left comes back
// through the outlet, while vortices pass it. Every particle that enters is new.
std::vector<Finding> swinging_stream() {
  const auto scene = scene_of(square("0.05 m", "0.005 Pa s", swinging, R"toml([materials.block]
type = "wall"
[[region]]
material = "block"
shape = "box"
lower = ["0.4 m", "0.3 m"]
upper = ["0.6 m", "0.6 m"]
[parameters]
U = "1 m/s"
w = "3 1/s"
[flow]
sound_speed = "25 m/s"
)toml"));
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const double start = double(fluid.state().rows.fluid().size());
  double least = start, most = start, distance = 1.0, density_error = 0.0, again = 0.0;
  std::set<std::uint32_t> before, gone;
  for (int k = 1; k <= 126; ++k) {
    fluid.advance(0.1 * k);
    const double now = double(fluid.state().rows.fluid().size());
    least = std::min(least, now);
    most = std::max(most, now);
    distance = std::min(distance, fluid.smallest_distance());
    density_error = std::max(density_error, fluid.density_error());
    std::set<std::uint32_t> here(fluid.particles().id.values().begin(), fluid.particles().id.values().end());
    for (const auto id : before)
      if (!here.contains(id)) gone.insert(id);
    for (const auto id : here) again += gone.contains(id) ? 1.0 : 0.0;
    before = std::move(here);
  }
  return {
      at_least("fewest particles, of those at the start (a column is 5 %)", least / start, 0.89),
      at_most("most particles, of those at the start", most / start, 1.11),
      at_least("smallest distance of particles, in spacings", distance, 0.1),
      at_most("largest density error", density_error, 0.06),
      exactly("ids that came back", again, 0.0),
      at_least("particles that entered, of those at the start", double(fluid.open_sides()->entered()) / start, 5.0)};
}

}  // namespace

std::vector<Case> hard_openings() {
  return {{"swinging-stream", "particles enter and leave at once, through both of two open sides", swinging_stream}};
}

}  // namespace shmoo::run::verify
