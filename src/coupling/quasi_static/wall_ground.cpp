#include "coupling/quasi_static/wall_ground.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "rdme/tensor_graph.hpp"

namespace shmoo::coupling {
namespace {

constexpr double reach = 2.6;          // spacings
constexpr double least_weight = 1e-9;  // of a source that counts

void add_filling(const WallPlan& plan, const Wall& wall, rdme::Voxels& voxels) {
  const double share = wall.cavity_volume() / double(std::max<std::size_t>(1, wall.filling().size()));
  for (const auto& x : wall.filling()) {
    voxels.position.push_back({plan.centre + x[0], x[1], 0.0});
    voxels.volume.push_back(share);
    voxels.material.push_back(std::uint16_t(plan.filling_material));
  }
}

// dC/dt = rate w (C0 - C) is an exit at the rate w and an entry of rate w C0 V molecules.
void add_sources(const WallPlan& plan, const Wall& wall, rdme::Voxels& voxels) {
  const auto arc = hydro::arc_length(wall.outer_surface());
  const auto& shell = wall.shell();
  std::map<std::pair<std::uint32_t, std::uint32_t>, rdme::Exchange> all;
  for (const auto& source : plan.scene.mechanics.sources) {
    for (std::size_t i = 0; i < shell.size(); ++i) {
      const double s = arc[i / std::size_t(shell.layers)] / source.width, weight = std::exp(-s * s);
      if (weight < least_weight) continue;
      const auto voxel = std::uint32_t(i), species = std::uint32_t(source.species);
      auto& exchange = all.try_emplace({voxel, species}, rdme::Exchange{voxel, species}).first->second;
      exchange.exit_rate += source.rate * weight;
      exchange.entry_rate += source.rate * weight * source.concentration * voxels.volume[i];
    }
  }
  for (const auto& [where, exchange] : all) voxels.exchanges.push_back(exchange);
}

}  // namespace

std::shared_ptr<const Ground> wall_ground(const WallPlan& plan, const Wall& wall, const rdme::Sampler* sampler) {
  auto ground = std::make_shared<Ground>();
  auto& voxels = ground->voxels;
  const auto& shell = wall.shell();
  voxels.volume = wall.volumes();
  voxels.material.assign(shell.size(), std::uint16_t(plan.material));
  for (const auto& x : shell.x) voxels.position.push_back({plan.centre + x[0], x[1], 0.0});
  const double depth = 2.0 * plan.scene.depth;  // with the mirror image
  voxels.graphs.push_back(
      rdme::make_tensor_graph({shell.x, voxels.volume, reach * wall.spacing(), plan.scene.axisymmetric, depth}));
  add_filling(plan, wall, voxels);
  voxels.graphs[0].first.resize(voxels.size() + 1, voxels.graphs[0].first.back());
  for (const auto& species : plan.scene.species) voxels.graph_of_species.push_back(species.diffusivity > 0.0 ? 0 : -1);
  add_sources(plan, wall, voxels);
  if (sampler) ground->tables = sampler->prepare(voxels);
  return ground;
}

void redistribute(rdme::State& state, const rdme::Network& network, std::span<const hydro::Take> takes,
                  const base::RandomKey& key, std::uint64_t step) {
  std::map<std::size_t, std::vector<hydro::Take>> by_giver;
  for (const auto& take : takes) by_giver[take.from].push_back(take);
  auto next = state;
  for (const auto& [from, parts] : by_giver) {
    std::fill_n(next.count.begin() + long(from * state.species), state.species, 0);
    if (!next.amount.empty()) std::fill_n(next.amount.begin() + long(from * state.species), state.species, 0.0);
  }
  for (const auto& [from, parts] : by_giver) {
    for (std::size_t s = 0; s < state.species; ++s) {
      base::RandomSequence random(key, base::Stream::rezoning, step, std::uint32_t(from), std::uint32_t(s));
      std::int64_t left = network.stochastic(int(s)) ? state.count[from * state.species + s] : 0;
      double share_left = 1.0;
      for (const auto& part : parts) {
        const bool last = &part == &parts.back();
        const double chance = last ? 1.0 : std::clamp(part.share / share_left, 0.0, 1.0);
        const auto moved = left > 0 ? base::binomial(random, left, chance) : 0;
        next.count[part.to * state.species + s] += moved;
        left -= moved;
        share_left -= part.share;
        if (!next.amount.empty())
          next.amount[part.to * state.species + s] += part.share * state.amount[from * state.species + s];
      }
    }
  }
  state = std::move(next);
}

}  // namespace shmoo::coupling
