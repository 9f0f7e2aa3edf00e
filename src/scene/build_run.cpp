// Numerics, times, what to record.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/build.hpp"
#include "scene/expression.hpp"
#include "scene/motion.hpp"
#include "scene/refinement.hpp"

namespace shmoo::scene {
namespace {

constexpr double most_records = 1e6;
constexpr std::array flow_fields{"position", "velocity", "density", "pressure"};

void check_reach(const Section& root, const Scene& scene) {
  const double width = 2 * scene.numerics.reach * scene.domain.spacing;
  const auto domain = root.section("domain");
  if (!domain || !domain->good("size") || !domain->good("spacing")) return;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimension); ++axis) {
    const double length = scene.domain.upper[axis] - scene.domain.lower[axis];
    const auto& sides = scene.domain.sides[axis];
    if ((sides[0].type == SideType::slip || sides[1].type == SideType::slip) && length < 0.55 * width)
      domain->error("size",
                    fmt::format("{:.6g} m along {} is less than a reach of the kernel and a bit, {:.6g} m, which a "
                                "side of type \"slip\" needs; enlarge it, or choose a smaller spacing",
                                length, axis_names[axis], 0.55 * width));
    if (scene.domain.sides[axis][0].type == SideType::periodic && length < width * (1 - 1e-12))
      domain->error(
          "size",
          fmt::format(
              "{:.6g} m along the periodic axis {} is less than two reaches of the kernel, {:.6g} m; enlarge it, "
              "or choose a smaller spacing",
              length, axis_names[axis], width));
  }
}

void read_times(const Section& section, Run& run) {
  const bool given = section.has("record_every");
  run.record_every = given ? section.quantity("record_every").value_or(0) : run.until / 10;
  if (run.until > 0 && run.record_every > run.until) section.error("record_every", "must not be longer than 'until'");
  if (run.record_every > 0 && run.until / run.record_every > most_records * (1 + 1e-9))
    section.error("record_every",
                  fmt::format("this makes {:.3g} records; at most {:.3g} are allowed; record less often",
                              run.until / run.record_every, most_records));
  run.record_at = section.quantities("record_at");
  std::sort(run.record_at.begin(), run.record_at.end());
  run.record_at.erase(std::unique(run.record_at.begin(), run.record_at.end()), run.record_at.end());
  if (!run.record_at.empty() && run.until > 0 && run.record_at.back() > run.until)
    section.error("record_at", "holds times after 'until'");
}

void read_quantiles(const Section& section, Run& run) {
  const auto* node = section.good("quantiles");
  if (!node) return;
  run.quantiles = quantities_of(*node);
  if (!std::is_sorted(run.quantiles.begin(), run.quantiles.end(), std::less_equal<>()))
    section.error("quantiles", "must ascend, without repetition");
}

void read_record(const Section& section, Scene& scene) {
  std::vector<std::string> known;
  for (const auto& species : scene.species) known.push_back(species.name);
  if (!scene.species.empty() && scene.compartments.empty()) known.emplace_back("volume");
  if (quasi_static(scene)) known.insert(known.end(), {"position", "hoop_strain", "hoop_stress"});
  if (in_motion(scene)) known.insert(known.end(), flow_fields.begin(), flow_fields.end());
  if (particles_come_and_go(scene)) known.emplace_back("particle");
  for (const auto& [name, node] : section.names("record")) {
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      scene.run.record.push_back(name);
      continue;
    }
    section.error(*node, "record",
                  fmt::format("this scene has no field {}{}", quoted(name),
                              suggestion(name, known, fmt::format("fields: {}", listed(known)))));
  }
}

}  // namespace

void build_numerics(const Section& root, Scene& scene) {
  Numerics& numerics = scene.numerics;
  if (const auto section = root.section("numerics")) {
    read_choice(*section, "kernel",
                std::array<std::pair<const char*, Kernel>, 4>{{{"lucy", Kernel::lucy},
                                                               {"cubic_spline", Kernel::cubic_spline},
                                                               {"quintic_spline", Kernel::quintic_spline},
                                                               {"wendland_c2", Kernel::wendland_c2}}},
                numerics.kernel);
    read_choice(*section, "pressure",
                std::array<std::pair<const char*, PressureForm>, 4>{{{"auto", PressureForm::automatic},
                                                                     {"symmetric", PressureForm::symmetric},
                                                                     {"difference", PressureForm::difference},
                                                                     {"riemann", PressureForm::riemann}}},
                numerics.pressure);
    read_choice(*section, "density",
                std::array<std::pair<const char*, DensityForm>, 3>{{{"auto", DensityForm::automatic},
                                                                    {"continuity", DensityForm::continuity},
                                                                    {"summation", DensityForm::summation}}},
                numerics.density);
    read_choice(*section, "viscous_step",
                std::array<std::pair<const char*, ViscousStep>, 3>{{{"auto", ViscousStep::automatic},
                                                                    {"explicit", ViscousStep::explicit_step},
                                                                    {"implicit", ViscousStep::implicit_step}}},
                numerics.viscous_step);
    read_choice(*section, "walls",
                std::array<std::pair<const char*, WallForm>, 3>{{{"auto", WallForm::automatic},
                                                                 {"extrapolated", WallForm::extrapolated},
                                                                 {"second-order", WallForm::second_order}}},
                numerics.walls);
    read_choice(
        *section, "sampler",
        std::array<std::pair<const char*, Sampler>, 5>{{{"direct", Sampler::direct},
                                                        {"composition_rejection", Sampler::composition_rejection},
                                                        {"split", Sampler::split},
                                                        {"tau_leaping", Sampler::tau_leaping},
                                                        {"auto", Sampler::automatic}}},
        numerics.sampler);
    read_choice(
        *section, "splitting",
        std::array<std::pair<const char*, Splitting>, 2>{{{"lie", Splitting::lie}, {"strang", Splitting::strang}}},
        numerics.splitting);
    read_choice(*section, "method", species_methods, numerics.method);
    read_choice(*section, "limits",
                std::array<std::pair<const char*, Limits>, 2>{{{"refuse", Limits::refuse}, {"warn", Limits::warn}}},
                numerics.limits);
    numerics.reach = section->number("reach").value_or(numerics.reach);
    numerics.shepard_every = static_cast<int>(section->integer("shepard_every").value_or(0));
    numerics.courant = section->number("courant").value_or(numerics.courant);
    numerics.splitting_step = section->quantity("splitting_step");
    numerics.tolerance = section->number("tolerance").value_or(numerics.tolerance);
    numerics.splitting_tolerance = section->number("splitting_tolerance").value_or(numerics.splitting_tolerance);
    numerics.leap_tolerance = section->number("leap_tolerance").value_or(numerics.leap_tolerance);
    numerics.steady_tolerance = section->number("steady_tolerance");
  }
  check_reach(root, scene);
}

void build_run(const Section& root, Scene& scene) {
  const auto section = root.section("run");
  if (!section) return;
  Run& run = scene.run;
  run.until = section->quantity("until").value_or(0);
  read_times(*section, run);
  run.realisations = static_cast<int>(section->integer("realisations").value_or(run.realisations));
  run.seed = static_cast<std::uint64_t>(section->integer("seed").value_or(1));
  read_quantiles(*section, run);
}

void build_record(const Section& root, Scene& scene) {
  if (const auto section = root.section("run")) read_record(*section, scene);
}

}  // namespace shmoo::scene
