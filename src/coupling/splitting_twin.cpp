#include "coupling/splitting_twin.hpp"

#include <algorithm>
#include <cmath>

#include "rdme/sampler.hpp"
#include "scene/well.hpp"

namespace shmoo::coupling {
namespace {

using rdme::Process;
using rdme::Treatment;

constexpr double part_of_tolerance = 1e-3;  // that the integration of the parts may cost

Treatment treatment(scene::SpeciesMethod method) {
  return method == scene::SpeciesMethod::stochastic ? Treatment::sampled
         : method == scene::SpeciesMethod::langevin ? Treatment::langevin
                                                    : Treatment::integrated;
}

// Where most reactions run.
int busiest_material(const rdme::Network& network, std::size_t materials) {
  std::vector<int> running(materials, 0);
  for (const auto& reaction : network.reactions())
    for (std::size_t m = 0; m < materials; ++m) running[m] += reaction.in_material[m] ? 1 : 0;
  return int(std::ranges::max_element(running) - running.begin());
}

}  // namespace

SplittingTwin::SplittingTwin(const scene::Scene& scene, const rdme::Network& network,
                             const std::vector<double>& reference)
    : smooth_(scene), scene_(scene), reference_(reference) {
  for (auto& species : smooth_.species) species.method = scene::SpeciesMethod::deterministic;
  scene::well_mixed(scene) ? make_well(network) : make_voxels(network);
  for (double& amount : reference_) amount *= voxels_.volume.front();
  for (const auto kind : {Treatment::integrated, Treatment::langevin, Treatment::sampled}) add_part(kind, network);
}

void SplittingTwin::make_well(const rdme::Network& network) {
  voxels_.volume = {1.0};
  voxels_.material = {0};
  voxels_.position = {{0.0, 0.0, 0.0}};
  voxels_.graph_of_species.assign(network.species(), -1);
}

void SplittingTwin::make_voxels(const rdme::Network& network) {
  const int material = busiest_material(network, scene_.materials.size());
  voxels_.volume.assign(2, std::pow(scene_.domain.spacing, scene_.dimension) * scene_.depth);
  voxels_.material.assign(2, std::uint16_t(material));
  voxels_.position = {scene_.domain.lower, scene_.domain.upper};
  const double coupling = 1.0 / (scene_.domain.spacing * scene_.domain.spacing);
  voxels_.graphs = {{{0, 1, 2}, {1, 0}, {coupling, coupling}, {}}};
  for (std::size_t s = 0; s < network.species(); ++s) {
    const bool moves = network.diffusivity(int(s)) > 0.0 && network.lives_in(int(s), material);
    voxels_.graph_of_species.push_back(moves ? 0 : -1);
    if (!network.lives_in(int(s), material)) reference_[s] = 0.0;
  }
}

// A part knows all species, but lets only its own react and move.
void SplittingTwin::add_part(Treatment kind, const rdme::Network& network) {
  scene::Scene own = smooth_;
  own.reactions.clear();
  bool anything = false;
  for (std::size_t r = 0; r < scene_.reactions.size(); ++r)
    if (network.reactions()[r].treatment() == kind) own.reactions.push_back(scene_.reactions[r]);
  for (std::size_t s = 0; s < own.species.size(); ++s) {
    if (treatment(scene_.species[s].method) != kind) own.species[s].diffusivity = 0.0;
    anything |= own.species[s].diffusivity > 0.0;
  }
  if (!anything && own.reactions.empty()) return;
  Part part;
  part.network = std::make_unique<rdme::Network>(own);
  const double tolerance = part_of_tolerance * scene_.numerics.splitting_tolerance;
  part.solver = std::make_unique<rdme::DeterministicSolver>(*part.network, tolerance);
  if (kind == Treatment::sampled && rdme::takes_turns(scene_.numerics.sampler))
    part.diffusion = std::make_unique<rdme::DeterministicSolver>(*part.network, tolerance);
  parts_.push_back(std::move(part));
}

void SplittingTwin::start() {
  if (parts_.empty()) return;
  state_ = rdme::empty_state(*parts_.front().network, voxels_.size());
  for (std::size_t s = 0; s < reference_.size(); ++s) {
    const bool moves = voxels_.graph_of_species[s] >= 0;
    for (std::size_t i = 0; i < voxels_.size(); ++i) {
      if (!moves || i == s % 2) state_.amount[i * reference_.size() + s] = reference_[s];
    }
  }
  for (auto& part : parts_) {
    part.solver->bind(voxels_, state_);
    if (part.diffusion) part.diffusion->bind(voxels_, state_);
  }
}

void SplittingTwin::advance(Part& part, double t, double h) {
  if (!part.diffusion) {
    part.solver->advance(t, h, Process::both);
    return;
  }
  part.solver->advance(t, 0.5 * h, Process::reactions);
  part.diffusion->advance(t, h, Process::diffusion);
  part.solver->advance(t + 0.5 * h, 0.5 * h, Process::reactions);
}

void SplittingTwin::step(double t, double h) {
  const bool strang = scene_.numerics.splitting == scene::Splitting::strang;
  for (std::size_t p = 0; p + 1 < parts_.size(); ++p) advance(parts_[p], t, strang ? 0.5 * h : h);
  advance(parts_.back(), t, h);
  for (std::size_t p = parts_.size() - 1; strang && p-- > 0;) advance(parts_[p], t + 0.5 * h, 0.5 * h);
}

int SplittingTwin::order() const {
  return scene_.numerics.splitting == scene::Splitting::strang || parts_.size() < 2 ? 2 : 1;
}

std::vector<double> SplittingTwin::amounts(double horizon, int steps) {
  std::vector<double> found;
  start();
  const double most = reference_.empty() ? 0.0 : *std::ranges::max_element(reference_);
  for (int k = 1; k <= steps && !parts_.empty(); ++k) {
    step(horizon * (k - 1) / steps, horizon / steps);
    if (8 * k != steps && 4 * k != steps && 2 * k != steps && k != steps) continue;
    for (std::size_t at = 0; at < state_.amount.size(); ++at) {
      const double scale = reference_[at % reference_.size()];
      found.push_back(state_.amount[at] / (scale > 0.0 ? scale : most > 0.0 ? most : 1.0));
    }
  }
  return found;
}

}  // namespace shmoo::coupling
