#include "rdme/sampler.hpp"

#include "base/error.hpp"
#include "rdme/samplers/composition_rejection.hpp"
#include "rdme/samplers/direct.hpp"

namespace shmoo::rdme {

std::unique_ptr<Sampler> make_sampler(scene::Sampler method, const Network& network) {
  switch (method) {
    case scene::Sampler::direct:
      return std::make_unique<Direct>(network);
    case scene::Sampler::composition_rejection:
      return std::make_unique<CompositionRejection>(network);
    case scene::Sampler::split:
      break;
  }
  throw base::InputError("the sampler 'split' is not in; use 'composition_rejection' or 'direct'");
}

}  // namespace shmoo::rdme
