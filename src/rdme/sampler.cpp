#include "rdme/sampler.hpp"

#include "base/error.hpp"
#include "rdme/samplers/composition_rejection.hpp"
#include "rdme/samplers/direct.hpp"
#include "rdme/samplers/one_well.hpp"
#include "rdme/samplers/split.hpp"
#include "rdme/samplers/tau_leaping.hpp"

namespace shmoo::rdme {

void Sampler::watch(EventWatch* watch) {
  if (!watch) return;
  throw base::InputError(
      "events that depend on amounts need a sampler that goes event by event; set numerics.sampler to "
      "\"composition_rejection\" or \"direct\"");
}

std::unique_ptr<Sampler> make_sampler(const scene::Numerics& numerics, const Network& network) {
  const bool unsplit =
      numerics.sampler == scene::Sampler::direct || numerics.sampler == scene::Sampler::composition_rejection;
  if (network.samples_surfaces() && !unsplit) {
    throw base::InputError(
        "reactions on surfaces join two voxels, which this numerics.sampler takes apart; set it to "
        "\"composition_rejection\" or \"direct\", which are exact");
  }
  switch (numerics.sampler) {
    case scene::Sampler::direct:
      return std::make_unique<Direct>(network);
    case scene::Sampler::composition_rejection:
      return std::make_unique<CompositionRejection>(network);
    case scene::Sampler::split:
      return std::make_unique<Split>(network);
    case scene::Sampler::tau_leaping:
      return std::make_unique<TauLeaping>(network, numerics.leap_tolerance);
    case scene::Sampler::automatic:
      break;
  }
  throw base::InputError("the sampler is undecided; rules must decide before anything runs");
}

std::unique_ptr<Sampler> make_sampler(scene::Sampler method, const Network& network) {
  scene::Numerics numerics;
  numerics.sampler = method;
  return make_sampler(numerics, network);
}

std::unique_ptr<Sampler> make_well_sampler(scene::Sampler method, const Network& network) {
  if (method == scene::Sampler::composition_rejection) return std::make_unique<OneWell>(network);
  return make_sampler(method, network);
}

}  // namespace shmoo::rdme
