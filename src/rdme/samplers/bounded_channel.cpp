#include "rdme/samplers/bounded_channel.hpp"

#include <algorithm>

#include "rdme/laws.hpp"

namespace shmoo::rdme {
namespace {

bool sampled(const Reaction& reaction) { return reaction.treatment() == Treatment::sampled; }

BoundedChannel jumps_of(std::uint32_t species, const Voxels& voxels, const JumpTables& tables, std::size_t stride) {
  BoundedChannel channel;
  channel.coefficient = tables.leave_rate.data() + species;
  bool equal = true;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    channel.largest = std::max(channel.largest, channel.coefficient[i * stride]);
    equal = equal && channel.coefficient[i * stride] == channel.coefficient[0];
  }
  channel.stride = equal ? 0 : stride;
  channel.species = species;
  channel.first = {species, 1, 0};
  channel.shift[0] = {species, -1};
  channel.shift[1] = {species, 1};
  channel.table = tables.of_species[species].get();
  return channel;
}

// Its constant in each voxel, or one for all.
std::vector<double> coefficients(const Reaction& law, const Voxels& voxels) {
  std::vector<double> all(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const double volume = voxels.volume[i];
    const std::size_t material = voxels.material[i];  // that of vacant voxels is beyond all others
    const bool runs = material < law.in_material.size() && law.in_material[material];
    all[i] = runs ? law.rate_constant * volume_factor(law.order, volume, 1 / volume) : 0.0;
  }
  if (std::ranges::adjacent_find(all, std::not_equal_to{}) == all.end()) {
    all.resize(1);
    all.shrink_to_fit();
  }
  return all;
}

void take_factors(const Reaction& law, BoundedChannel& channel) {
  channel.simple = law.order <= 2;
  BoundedChannel::Factor* factor = &channel.first;
  for (const auto& term : law.reactants)
    for (int k = 0; k < term.count && channel.simple; ++k, factor = &channel.second)
      *factor = {std::uint32_t(term.species), 1.0, double(-k)};
}

BoundedChannel channel_of(int reaction, const Network& network, const Voxels& voxels) {
  const Reaction& law = network.reactions()[std::size_t(reaction)];
  BoundedChannel channel;
  channel.own = coefficients(law, voxels);
  channel.coefficient = channel.own.data();
  channel.stride = channel.own.size() > 1 ? 1 : 0;
  channel.largest = std::ranges::max(channel.own);
  channel.reaction = reaction;
  take_factors(law, channel);
  channel.whole = law.changes.size() <= channel.shift.size();
  for (std::size_t k = 0; k < law.changes.size() && channel.whole; ++k) {
    channel.shift[k] = {std::uint32_t(law.changes[k].species), law.changes[k].amount};
    channel.whole = network.stochastic(law.changes[k].species);
  }
  return channel;
}

}  // namespace

bool all_bounded(const Network& network) {
  return network.varying().empty() && std::ranges::all_of(network.reactions(), [&](const Reaction& law) {
           const auto whole = [&](const auto& term) { return network.stochastic(term.species); };
           return !sampled(law) ||
                  (law.expression.empty() && !law.on_surface() && std::ranges::all_of(law.reactants, whole));
         });
}

std::vector<BoundedChannel> bounded_channels(const Network& network, const Voxels& voxels, const JumpTables& tables,
                                             Process process) {
  std::vector<BoundedChannel> channels;
  for (std::uint32_t s = 0; process != Process::reactions && s < network.species(); ++s)
    if (tables.moves(s)) channels.push_back(jumps_of(s, voxels, tables, network.species()));
  for (std::size_t r = 0; process != Process::diffusion && r < network.reactions().size(); ++r)
    if (sampled(network.reactions()[r])) channels.push_back(channel_of(int(r), network, voxels));
  return channels;
}

}  // namespace shmoo::rdme
