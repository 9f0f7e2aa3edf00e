#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/rules/limits.hpp"
#include "coupling/splitting.hpp"
#include "scene/surface.hpp"

namespace shmoo::coupling {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr double slowdown_ok = 0.1;

// Two molecules that meet by diffusion between voxels, and the rate constant of the pair [m^3/s].
struct Meeting {
  std::string reaction;
  double rate = 0;         // k' = k for A + B, 2 k for 2 A
  double diffusivity = 0;  // [m^2/s] D_A + D_B
  double voxels = 0;       // that both can be in
};

std::vector<Meeting> meetings(const scene::Scene& scene, const Numbers& numbers) {
  std::vector<Meeting> list;
  for (const auto& reaction : scene.reactions) {
    if (!reaction.expression.empty() || scene::on_surface(reaction)) continue;
    const auto& terms = reaction.reactants;
    const bool alike = terms.size() == 1 && terms[0].count == 2;
    if (!alike && !(terms.size() == 2 && terms[0].count == 1 && terms[1].count == 1)) continue;
    const auto& a = numbers.species[std::size_t(terms.front().species)];
    const auto& b = numbers.species[std::size_t(terms.back().species)];
    list.push_back({reaction.name, (alike ? 2.0 : 1.0) * reaction.rate_constant, a.diffusivity + b.diffusivity,
                    double(std::min(a.home, b.home))});
  }
  return list;
}

// Mean time to meet over the mean time to react in a common voxel, so that a rate constant k acts as k/(1 + s). On a
// lattice of N points a walker needs 1.5164 N steps (3-D) or N (ln N/pi + 0.1951) steps (2-D) to a given point
// (Montroll & Weiss 1965); with h^2/(2 D d) a step that is 0.2527 k/(D h) in 3-D (Erban & Chapman 2009; Hellander,
// Hellander & Petzold 2012). In 1-D voxels may be as small as one likes.
double slowdown(const Meeting& meeting, const scene::Scene& scene, double spacing) {
  if (scene.dimension == 3) return 1.5164 / 6.0 * meeting.rate / (meeting.diffusivity * spacing);
  return meeting.rate / scene.depth / meeting.diffusivity * (std::log(meeting.voxels) / (4.0 * pi) + 0.1951 / 4.0);
}

// The spacing at which it is just well; 0 where none is.
double best_spacing(const Meeting& meeting, const scene::Scene& scene, double spacing) {
  if (scene.dimension == 3) return slowdown(meeting, scene, spacing) / slowdown_ok * spacing;
  const double log_voxels = 4.0 * pi * (slowdown_ok * meeting.diffusivity * scene.depth / meeting.rate - 0.1951 / 4.0);
  return log_voxels > 0.0 ? spacing * std::sqrt(meeting.voxels / std::exp(log_voxels)) : 0.0;
}

void add_smallest_voxel(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  if (scene.dimension == 1 || numbers.voxels < 2) return;
  for (const auto& meeting : meetings(scene, numbers)) {
    if (!(meeting.diffusivity > 0.0) || meeting.voxels < 2) continue;
    const double spacing = best_spacing(meeting, scene, numbers.spacing);
    limits.push_back({"voxels too small for " + meeting.reaction, slowdown(meeting, scene, numbers.spacing),
                      slowdown_ok, 10.0,
                      "time to meet over time to react, by which the reaction is slower than its constant says",
                      spacing > 0.0 ? fmt::format("set domain.spacing to at least {:.2g} m", spacing)
                                    : "the reaction is limited by diffusion at any spacing; give a smaller constant",
                      "Erban & Chapman 2009; Hellander, Hellander & Petzold 2012; Montroll & Weiss 1965"});
  }
}

void add_largest_voxel(const Numbers& numbers, std::vector<Limit>& limits) {
  if (numbers.voxels < 2) return;
  for (const auto& species : numbers.species) {
    if (!(species.diffusivity > 0.0) || !(species.turnover > 0.0) || species.home < 2) continue;
    const double length = std::sqrt(species.diffusivity / species.turnover);
    limits.push_back(
        {"voxels too large for " + species.name, numbers.spacing / length, 1.0, infinite,
         fmt::format("dp/sqrt(D/k) = {:.3g}/{:.3g} m; beyond 1 it reacts before it has crossed a voxel, and "
                     "fronts are not resolved",
                     numbers.spacing, length),
         fmt::format("set domain.spacing to at most {:.2g} m", length),
         "Kuramoto 1974; Isaacson & Peskin 2006: well mixed on the scale of a voxel"});
  }
}

void add_splitting(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  if (!scene.numerics.splitting_step) return;
  double fastest = 0.0;
  for (const auto& species : numbers.species) fastest = std::max(fastest, species.turnover);
  if (fastest == 0.0) return;
  limits.push_back({"splitting step", *scene.numerics.splitting_step * fastest, 0.02, infinite,
                    fmt::format("numerics.splitting_step x fastest turnover = {:.3g} s x {:.3g} 1/s",
                                *scene.numerics.splitting_step, fastest),
                    fmt::format("leave it out, or give at most {:.2g} s", 0.02 / fastest),
                    "Strang 1968: error of second order in the step over the time scale"});
}

// Langevin amounts are Gaussian numbers kept above zero: right to 1/n in means, and no law at all for few.
void add_langevin(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  for (std::size_t s = 0; s < scene.species.size(); ++s) {
    if (scene.species[s].method != scene::SpeciesMethod::langevin) continue;
    const double n = numbers.species[s].per_voxel;
    limits.push_back({"smooth noise of " + numbers.species[s].name, n > 0.0 ? 1.0 / n : infinite, 0.01, 0.1,
                      fmt::format("1/n of {:.3g} molecules in a voxel: numbers below 100 are not Gaussian", n),
                      "set its method to \"stochastic\", or take a larger domain.spacing",
                      "Gillespie 2000; Grima, Thomas & Straube 2011"});
  }
}

}  // namespace

void judge_chemistry_limits(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  add_smallest_voxel(scene, numbers, limits);
  add_largest_voxel(numbers, limits);
  add_splitting(scene, numbers, limits);
  add_langevin(scene, numbers, limits);
}

}  // namespace shmoo::coupling
