// Which sampler draws the events of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/rules/rule.hpp"
#include "scene/surface.hpp"

namespace shmoo::coupling {
namespace {

using scene::Sampler;

// Of what is sampled, at the reference concentrations.
struct Load {
  double watches = 0;          // events of the model, which end steps and may look at every number
  double surfaces = 0;         // reactions on surfaces
  double events = 0;           // of a realisation, jumps and reactions
  double jumps_per_event = 0;  // of reactions
  double leap = 0;             // events of each reaction in a leap of a voxel
};

// A leap is limited by the spread of each reactant (Cao, Gillespie & Petzold 2006, Eq. 33, with g = 2): it lasts
// max(epsilon n/2, 1)^2/(2 a), a the events that use it up in a voxel [1/s].
Load load_of(const scene::Scene& scene, const Numbers& numbers) {
  double jumps = 0.0, reactions = 0.0, in_voxel = 0.0, leap = std::numeric_limits<double>::infinity();  // [1/s], [s]
  for (std::size_t s = 0; s < numbers.species.size(); ++s) {
    const auto& one = numbers.species[s];
    if (scene.species[s].method != scene::SpeciesMethod::stochastic) continue;
    const double there = std::max(one.start, one.per_voxel), used = one.per_voxel * one.turnover;
    if (one.home > 1) jumps += there * 2.0 * numbers.dimension * one.diffusivity / (numbers.spacing * numbers.spacing);
    reactions += there * one.turnover;
    in_voxel += used;
    const double change = std::max(0.5 * scene.numerics.leap_tolerance * one.per_voxel, 1.0);
    if (used > 0.0) leap = std::min(leap, 0.5 * change * change / used);
  }
  const double kinds = double(std::max<std::size_t>(1, scene.reactions.size()));
  const auto surfaces = std::count_if(scene.reactions.begin(), scene.reactions.end(), scene::on_surface);
  return {double(scene.events.size()), double(surfaces), (jumps + reactions) * scene.run.until,
          reactions > 0.0 ? jumps / reactions : 0.0, in_voxel > 0.0 ? in_voxel * leap / kinds : 0.0};
}

struct SamplerRule {
  const char* number;
  double threshold;
  const char* source;
  double Load::*value;
  bool below;  // holds below the threshold, else from it on
  Sampler sampler;
  const char* reason;  // a format of the value
};

constexpr SamplerRule rules[] = {
    {"events that the model names", 1, "their triggers are looked at after each reaction event", &Load::watches, false,
     Sampler::composition_rejection, "{:g} events of the model are watched between reaction events"},
    {"reactions on surfaces", 1, "they join two voxels, whose turns cannot be taken apart", &Load::surfaces, false,
     Sampler::composition_rejection, "{:g} reactions join voxels of two materials"},
    {"events of a realisation", 1e7, "shmoo bench: exact methods draw about 10^7 events a second", &Load::events, true,
     Sampler::composition_rejection, "{:.3g} events are drawn one by one in about a second, without error"},
    {"events of each reaction in a leap of a voxel", 8, "shmoo bench; Cao, Gillespie & Petzold 2006", &Load::leap,
     false, Sampler::tau_leaping,
     "{:.3g} events of each reaction fit in a leap; means err by less than 0.1 % at leap_tolerance = 0.03"},
    {"jumps for each reaction event", 2, "shmoo bench: jumps without events are up to a hundred times as fast",
     &Load::jumps_per_event, false, Sampler::split,
     "{:.3g} jumps for each reaction event, which need no events of their own; the error is that of the splitting "
     "step"},
    {"jumps for each reaction event", 2, "shmoo bench", &Load::jumps_per_event, true, Sampler::composition_rejection,
     "reactions prevail ({:.3g} jumps for each), in voxels of few molecules: exact events cost least"},
};

const char* word(Sampler sampler) {
  constexpr const char* words[] = {"direct", "composition_rejection", "split", "tau_leaping", "auto"};
  return words[int(sampler)];
}

}  // namespace

Decision judge_sampler(scene::Scene& scene, const Numbers& numbers) {
  const Load load = load_of(scene, numbers);
  Decision decision{.key = "numerics.sampler"};
  decision.automatic = scene.numerics.sampler == Sampler::automatic;
  for (const SamplerRule& rule : rules) {
    const double value = load.*rule.value;
    if (rule.below ? value >= rule.threshold : value < rule.threshold) continue;
    if (decision.automatic)
      scene.numerics.sampler = rule.sampler;
    else if (scene.numerics.sampler != rule.sampler)
      decision.by_rule = word(rule.sampler);
    decision.number = value;
    decision.looked_at = rule.number;
    decision.threshold = rule.threshold;
    decision.source = rule.source;
    decision.reason = fmt::format(fmt::runtime(rule.reason), value);
    break;
  }
  decision.value = word(scene.numerics.sampler);
  return decision;
}

}  // namespace shmoo::coupling
