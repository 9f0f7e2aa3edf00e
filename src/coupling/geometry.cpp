#include "coupling/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/held_surface.hpp"
#include "rdme/surface/contacts.hpp"
#include "rdme/unlisted_jumps.hpp"
#include "rdme/voronoi.hpp"
#include "scene/surface.hpp"

namespace shmoo::coupling {
namespace {

// Beside a cylinder in a stream capacities stay within 8 % of what the particles fill; with one sweep of a seventh they
// were off by 64 %, and conduction with them.
constexpr int sweeps = 4;               // of the relaxation of capacities, in an interval
constexpr double part_of_excess = 0.5;  // that one sweep moves at most

constexpr std::uint32_t surface = 6;  // boundaries 0..5 are sides, 6 + material its surface

rdme::SideUse use_of(scene::BoundaryType type) {
  switch (type) {
    case scene::BoundaryType::reflect:
      return rdme::SideUse::reflect;
    case scene::BoundaryType::flux:
      return rdme::SideUse::flux;
    case scene::BoundaryType::fixed:
    case scene::BoundaryType::absorb:
      break;
  }
  return rdme::SideUse::open;
}

bool clamps(scene::BoundaryType type) {
  return type == scene::BoundaryType::fixed || type == scene::BoundaryType::absorb;
}

// Copies the carried volume onto the pairs that the habitat shares with the carrying graph; both rows ascend by target.
void attach_flow(const rdme::JumpGraph& carrying, rdme::JumpGraph& graph) {
  graph.flow.assign(graph.target.size(), 0.0);
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i) {
    std::uint64_t c = carrying.first[i];
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      while (c < carrying.first[i + 1] && carrying.target[c] < graph.target[p]) ++c;
      if (c < carrying.first[i + 1] && carrying.target[c] == graph.target[p]) graph.flow[p] = carrying.flow[c];
    }
  }
}

}  // namespace

template <int D>
Geometry<D>::Geometry(const scene::Scene& scene, const sph::Filling<D>& filling)
    : scene_(scene),
      box_(filling.box),
      material_(filling.particles.material.values().begin(),
                filling.particles.material.values().begin() + long(filling.voxels)),
      vacant_(filling.vacant),
      kernel_(sph::make_kernel<D>(scene.numerics.kernel, scene.numerics.reach * filling.spacing.maxCoeff())),
      cell_(filling.cell),
      moving_rows_(filling.box, reach(), 0.3 * filling.spacing.maxCoeff()),
      moving_clusters_(filling.box, reach(), 0.3 * filling.spacing.maxCoeff()) {
  // Places for what enters hold what the domain is filled with: a flow has one fluid.
  const auto fluid = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [](const auto& one) { return one.type == scene::MaterialType::fluid; });
  material_.resize(filling.voxels + filling.reserve, std::uint16_t(fluid - scene.materials.begin()));
  if (scene.effects.flow && scene.effects.species_advection) {
    carried_.assign(scene.materials.size() + 1, false);
    for (const auto& species : scene.species) {
      for (const int home : species.homes) {
        const auto m = static_cast<std::size_t>(home);
        carried_[m] = carried_[m] || scene.materials[m].type == scene::MaterialType::fluid;
      }
    }
    if (std::find(carried_.begin(), carried_.end(), true) == carried_.end()) carried_.clear();
  }
  find_habitats();
  for (const auto& habitat : habitats_) surfaces_.push_back(held_surface<D>(scene, habitat));
}

template <int D>
bool Geometry<D>::lives_in(std::size_t species, std::uint16_t material) const {
  const auto& homes = scene_.species[species].homes;
  return std::find(homes.begin(), homes.end(), int(material)) != homes.end();
}

template <int D>
std::vector<std::uint16_t> Geometry<D>::material_in(const Frame<D>& frame) const {
  auto material = material_;
  for (std::size_t i = 0; i < frame.vacant.size(); ++i)
    if (frame.vacant[i]) material[i] = std::uint16_t(scene_.materials.size());
  return material;
}

template <int D>
void Geometry<D>::find_habitats() {
  const std::size_t materials = scene_.materials.size() + 1;  // the last is that of vacant voxels
  for (std::size_t s = 0; s < scene_.species.size(); ++s) {
    const std::vector<bool> none(materials, false);
    rdme::Habitat habitat{none, none, none, none, {}};
    bool moves = scene_.species[s].diffusivity > 0.0;
    for (const int home : scene_.species[s].homes) {
      habitat.home[static_cast<std::size_t>(home)] = true;
      moves = moves || (!carried_.empty() && carried_[static_cast<std::size_t>(home)]);
    }
    for (const auto& boundary : scene_.boundaries) {
      if (boundary.species != int(s)) continue;
      if (boundary.axis >= 0) {
        habitat.side[static_cast<std::size_t>(2 * boundary.axis + boundary.side)] = use_of(boundary.type);
      } else if (clamps(boundary.type)) {
        habitat.clamped[static_cast<std::size_t>(boundary.material)] = true;
        habitat.home[static_cast<std::size_t>(boundary.material)] = false;
      } else if (boundary.type == scene::BoundaryType::flux) {
        habitat.source[static_cast<std::size_t>(boundary.material)] = true;
        moves = true;
      }
    }
    if (!moves) {
      habitat_of_species_.push_back(-1);
      continue;
    }
    const auto known = std::find(habitats_.begin(), habitats_.end(), habitat);
    habitat_of_species_.push_back(static_cast<int>(known - habitats_.begin()));
    if (known == habitats_.end()) habitats_.push_back(habitat);
  }
}

template <int D>
std::vector<double> Geometry<D>::capacities(std::span<const base::Vec<D>> position) const {
  if (scene_.effects.flow || scene_.domain.jitter == 0.0) return std::vector<double>(position.size(), cell_);
  return rdme::voronoi_cells<D>(position, vacant_, box_, std::pow(cell_, 1.0 / D)).volume;
}

// Kernel weights are exact for linear profiles on a lattice only. Where particles stand off it, faces are found once.
template <int D>
rdme::PairWeights Geometry<D>::weights(const Frame<D>& frame) const {
  const bool off_lattice = scene_.effects.flow || scene_.domain.jitter > 0.0;
  return frame.steady && off_lattice ? rdme::PairWeights::faces : rdme::PairWeights::kernel;
}

template <int D>
rdme::HabitatGraph Geometry<D>::habitat_graph(const Frame<D>& frame, const rdme::Places<D>& places,
                                              const sph::NeighbourRows<D>& near, std::size_t habitat) const {
  const auto& surface = surfaces_[habitat];
  return rdme::make_habitat_graph<D>(places, near, box_, kernel_, scene_.depth, habitats_[habitat], weights(frame),
                                     surface ? &*surface : nullptr);
}

template <int D>
double Geometry<D>::reach() const {
  return std::visit([](const auto& kernel) { return kernel.reach(); }, kernel_);
}

// Rows of particles that will move on are kept as long as they serve.
template <int D>
std::shared_ptr<const sph::NeighbourRows<D>> Geometry<D>::rows(const Frame<D>& frame) const {
  if (!frame.steady) return moving_rows_.at(frame.position);
  moving_rows_.forget();
  auto rows = std::make_shared<sph::NeighbourRows<D>>();
  rows->build(frame.position, box_, reach());
  rows->sort();
  return rows;
}

template <int D>
rdme::JumpGraph Geometry<D>::carrying_graph(const Frame<D>& frame) const {
  const std::vector<bool> none(carried_.size(), false);
  const auto material = material_in(frame);
  const rdme::Habitat habitat{carried_, none, none, carried_, {}};
  const rdme::Places<D> places{frame.position, frame.departure_capacity, frame.drift, material, vacant_};
  auto graph =
      rdme::make_habitat_graph<D>(places, *rows(frame), box_, kernel_, scene_.depth, habitat, weights(frame)).graph;
  std::vector<double> volume(frame.departure_capacity);
  for (double& v : volume) v *= scene_.depth;
  if (frame.steady)
    rdme::make_divergence_free(graph, volume);
  else
    relax(graph, volume, frame);
  return graph;
}

// Sweeps of explicit diffusion over the interval, after what the fluid carries. `held` [m^3] at its beginning.
template <int D>
void Geometry<D>::relax(rdme::JumpGraph& graph, const std::vector<double>& held, const Frame<D>& frame) const {
  const double duration = frame.duration;
  const auto pairs = [&](std::size_t i, auto visit) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) visit(p, graph.target[p]);
  };
  std::vector<double> volume(held);
  double fastest = 0.0;  // [1/m^2]
  for (std::size_t i = 0; i < held.size(); ++i) {
    double pace = 0.0;
    pairs(i, [&](std::uint64_t p, std::uint32_t) { pace += graph.coupling[p]; });
    fastest = std::max(fastest, pace);
    pairs(i, [&](std::uint64_t p, std::uint32_t) { volume[i] -= graph.flow[p] * duration; });
  }
  if (fastest == 0.0 || duration == 0.0) return;
  const double part =
      part_of_excess * std::min(1.0, duration / frame.relaxation_time) / (fastest * cell_ * scene_.depth);  // [1/m]
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::vector<double> before(volume);
    for (std::size_t i = 0; i < held.size(); ++i) {
      pairs(i, [&](std::uint64_t p, std::uint32_t j) {
        const double passes = part * held[i] * graph.coupling[p] * (before[i] - before[j]);
        graph.flow[p] += passes / duration;
        volume[i] -= passes;
      });
    }
  }
}

template <int D>
rdme::Voxels Geometry<D>::voxels(const Frame<D>& frame, const std::vector<bool>& sampled) const {
  rdme::Voxels voxels;
  voxels.material = material_in(frame);
  voxels.volume.reserve(frame.position.size());
  voxels.position.reserve(frame.position.size());
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    voxels.volume.push_back(frame.capacity[i] * scene_.depth);
    auto& place = voxels.position.emplace_back();
    for (int a = 0; a < D; ++a) place[a] = frame.position[i][a];
  }
  voxels.graph_of_species = habitat_of_species_;
  add_graphs(frame, sampled, voxels);
  std::stable_sort(voxels.exchanges.begin(), voxels.exchanges.end(), [](const auto& a, const auto& b) {
    return a.voxel != b.voxel ? a.voxel < b.voxel : a.species < b.species;
  });
  add_surfaces({frame.position, frame.capacity, {}, voxels.material, vacant_}, voxels);
  return voxels;
}

// Whether the jumps of a habitat are written down. They need not be where particles move on, no voxel is vacant,
// nothing is carried, and molecules are all that jumps.
template <int D>
bool Geometry<D>::listed(std::size_t habitat, const Frame<D>& frame, const std::vector<bool>& sampled) const {
  if (frame.steady || !frame.vacant.empty() || !frame.drift.empty() || !rdme::can_stay_unlisted(habitats_[habitat]))
    return true;
  bool any = !scene_.inflows.empty();
  for (std::size_t s = 0; s < habitat_of_species_.size(); ++s)
    any = any || (habitat_of_species_[s] == int(habitat) && (s >= sampled.size() || !sampled[s]));
  return any;
}

template <int D>
void Geometry<D>::add_graphs(const Frame<D>& frame, const std::vector<bool>& sampled, rdme::Voxels& voxels) const {
  rdme::JumpGraph carrying;
  if (!frame.drift.empty()) carrying = carrying_graph(frame);
  const rdme::Places<D> places{frame.position, frame.capacity, {}, voxels.material, vacant_};
  std::shared_ptr<const sph::NeighbourRows<D>> near;
  std::vector<std::vector<rdme::Contact>> contacts(habitats_.size());
  voxels.graphs.resize(habitats_.size());
  voxels.unlisted.resize(habitats_.size());
  for (std::size_t h = 0; h < habitats_.size(); ++h) {
    if (!listed(h, frame, sampled)) {
      voxels.unlisted[h] =
          rdme::make_unlisted_jumps<D>(places, moving_clusters_.at(frame.position), kernel_, habitats_[h]);
      continue;
    }
    if (!near) near = rows(frame);
    auto made = habitat_graph(frame, places, *near, h);
    if (!frame.drift.empty()) attach_flow(carrying, made.graph);
    voxels.graphs[h] = std::move(made.graph);
    contacts[h] = std::move(made.contacts);
  }
  for (std::size_t s = 0; s < scene_.species.size(); ++s) {
    if (habitat_of_species_[s] >= 0) add_boundary_exchanges(s, contacts[std::size_t(habitat_of_species_[s])], voxels);
    add_sponge_exchanges(s, voxels);
  }
}

template <int D>
void Geometry<D>::add_surfaces(const rdme::Places<D>& places, rdme::Voxels& voxels) const {
  for (const auto& reaction : scene_.reactions) {
    if (!scene::on_surface(reaction) || voxels.surface(reaction.surface)) continue;
    voxels.surfaces.push_back(
        rdme::make_surface<D>(places, box_, std::pow(cell_, 1.0 / D), scene_.depth, reaction.surface));
    if (!voxels.surfaces.back().target.empty()) continue;
    throw base::InputError(fmt::format(
        "reaction {} runs where {} and {} touch, but no two of their particles are neighbours; look at the regions",
        reaction.name, scene_.materials[std::size_t(reaction.surface[0])].name,
        scene_.materials[std::size_t(reaction.surface[1])].name));
  }
}

// Where a contact is with the boundary that the condition speaks of; nothing passes elsewhere.
template <int D>
rdme::Exchange Geometry<D>::exchange_of(const scene::SpeciesBoundary& boundary, const rdme::Contact& contact,
                                        double volume) const {
  const auto species = static_cast<std::uint32_t>(boundary.species);
  const auto key = boundary.axis >= 0 ? std::uint32_t(2 * boundary.axis + boundary.side)
                                      : surface + static_cast<std::uint32_t>(boundary.material);
  if (key != contact.boundary || boundary.type == scene::BoundaryType::reflect) return {contact.voxel, species, 0, 0};
  const double exit = scene_.species[species].diffusivity * contact.exchange;
  const double held = boundary.type == scene::BoundaryType::fixed ? boundary.value : 0.0;
  const double flux = boundary.type == scene::BoundaryType::flux ? boundary.value * contact.area : 0.0;
  return {contact.voxel, species, exit, exit * held * volume + flux};
}

template <int D>
void Geometry<D>::add_boundary_exchanges(std::size_t species, const std::vector<rdme::Contact>& contacts,
                                         rdme::Voxels& voxels) const {
  for (const auto& contact : contacts) {
    for (const auto& boundary : scene_.boundaries) {
      if (boundary.species != int(species)) continue;
      const auto exchange = exchange_of(boundary, contact, voxels.volume[contact.voxel]);
      if (exchange.exit_rate > 0.0 || exchange.entry_rate > 0.0) voxels.exchanges.push_back(exchange);
    }
  }
}

template <int D>
double Geometry<D>::flux(const Frame<D>& frame, std::size_t species, int side, int material,
                         const std::vector<double>& concentration) const {
  if (habitat_of_species_[species] < 0) return 0.0;
  const auto of_voxel = material_in(frame);
  const rdme::Places<D> places{frame.position, frame.capacity, {}, of_voxel, vacant_};
  const auto graph = habitat_graph(frame, places, *rows(frame), std::size_t(habitat_of_species_[species]));
  double sum = 0.0;
  for (const auto& boundary : scene_.boundaries) {
    const bool here = side < 0 ? boundary.axis < 0 && boundary.material == material
                               : boundary.axis >= 0 && 2 * boundary.axis + boundary.side == side;
    if (boundary.species != int(species) || !here) continue;
    for (const auto& contact : graph.contacts) {
      const double volume = frame.capacity[contact.voxel] * scene_.depth;
      const auto exchange = exchange_of(boundary, contact, volume);
      sum += exchange.entry_rate - exchange.exit_rate * volume * concentration[contact.voxel];
    }
  }
  return sum;
}

template <int D>
void Geometry<D>::add_sponge_exchanges(std::size_t species, rdme::Voxels& voxels) const {
  for (const auto& inflow : scene_.inflows) {
    for (const auto& [which, target] : inflow.species) {
      if (which != int(species)) continue;
      const sph::Sponge sponge(inflow, std::max(scene_.species[species].diffusivity, 1e-300), D);
      for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (!lives_in(species, voxels.material[i])) continue;
        const double rate = sponge.rate(voxels.position[i]);
        if (rate == 0.0) continue;
        voxels.exchanges.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(species), rate,
                                    rate * target * voxels.volume[i]});
      }
    }
  }
}

template class Geometry<1>;
template class Geometry<2>;
template class Geometry<3>;

}  // namespace shmoo::coupling
