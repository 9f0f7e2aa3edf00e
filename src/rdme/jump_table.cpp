#include "rdme/jump_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

void check(double rate, const char* what, const std::string& species, std::size_t voxel) {
  if (rate >= 0 && std::isfinite(rate)) return;
  throw base::RunError(
      fmt::format("the {} rate of species {} in voxel {} is {} 1/s; it must be a finite number >= 0: look at the "
                  "diffusivity and at the volumes",
                  what, species, voxel, rate));
}

const JumpGraph* graph_of(const Network& network, const Voxels& voxels, int species) {
  const int graph = voxels.graph_of_species[species];
  if (graph < 0) return nullptr;
  const bool still = network.diffusivity(species) == 0 && voxels.graphs[graph].flow.empty();
  return still ? nullptr : &voxels.graphs[graph];
}

void sum_rates(const Network& network, const Voxels& voxels, JumpTables& tables) {
  const std::size_t stride = network.species();
  for (std::size_t s = 0; s < stride; ++s) {
    const int species = static_cast<int>(s);
    const JumpGraph* graph = network.stochastic(species) ? graph_of(network, voxels, species) : nullptr;
    if (!graph) continue;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      double sum = 0;
      for (std::uint64_t p = graph->first[i]; p < graph->first[i + 1]; ++p) {
        sum += jump_rate(*graph, p, network.diffusivity(species), voxels.volume[i]);
      }
      check(sum, "jump", network.name(species), i);
      tables.leave_rate[i * stride + s] = sum;
    }
  }
}

// Exit rates by species and voxel; entries go straight to the tables.
std::vector<std::map<std::uint32_t, double>> sum_exchanges(const Network& network, const Voxels& voxels,
                                                           JumpTables& tables) {
  const std::size_t stride = network.species();
  std::vector<std::map<std::uint32_t, double>> exits(stride);
  for (const Exchange& exchange : voxels.exchanges) {
    const int species = static_cast<int>(exchange.species);
    if (!network.stochastic(species)) continue;
    check(exchange.exit_rate, "exit", network.name(species), exchange.voxel);
    check(exchange.entry_rate, "entry", network.name(species), exchange.voxel);
    const std::size_t at = exchange.voxel * stride + exchange.species;
    if (exchange.exit_rate > 0) exits[species][exchange.voxel] += exchange.exit_rate;
    tables.leave_rate[at] += exchange.exit_rate;
    if (exchange.entry_rate == 0) continue;
    if (tables.entry_rate.empty()) tables.entry_rate.assign(voxels.size() * stride, 0.0);
    tables.entry_rate[at] += exchange.entry_rate;
  }
  return exits;
}

// `uniform` 0: rows of jumps only.
std::shared_ptr<const JumpTable> make_table(const Voxels& voxels, const JumpGraph* graph, double kappa, double uniform,
                                            const std::map<std::uint32_t, double>& exits) {
  const std::size_t size = voxels.size();
  auto table = std::make_shared<JumpTable>(size, graph ? graph->target.size() : exits.size());
  std::vector<double> weights;
  std::vector<std::uint32_t> targets;
  for (std::size_t i = 0; i < size; ++i) {
    weights.clear();
    targets.clear();
    double sum = 0;
    const auto add = [&](double weight, std::size_t target) {
      weights.push_back(weight);
      targets.push_back(static_cast<std::uint32_t>(target));
      sum += weight;
    };
    for (std::uint64_t p = graph ? graph->first[i] : 0; graph && p < graph->first[i + 1]; ++p) {
      add(jump_rate(*graph, p, kappa, voxels.volume[i]), graph->target[p]);
    }
    if (const auto exit = exits.find(static_cast<std::uint32_t>(i)); exit != exits.end()) add(exit->second, size);
    if (uniform > sum * (1 + 1e-14)) add(uniform - sum, i);
    table->add_row(weights, targets);
  }
  table->add_row(std::vector<double>{1.0}, std::vector<std::uint32_t>{static_cast<std::uint32_t>(size)});
  return table;
}

}  // namespace

JumpTable::JumpTable(std::size_t voxels, std::size_t pairs) {
  first_.reserve(voxels + 2);
  first_.push_back(0);
  blocks_.reserve(voxels * (pairs / (8 * voxels + 1) + 1) + 1);
}

void JumpTable::add_row(std::span<const double> weights, std::span<const std::uint32_t> targets) {
  double sum = 0;
  for (double weight : weights) sum += weight;
  double below = 0;
  std::size_t k = 0;  // entries in use
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0) continue;
    if (k % 8 == 0) {
      Block fresh;
      std::fill_n(fresh.threshold, 8, 0xFFFFFFFFU);
      std::fill_n(fresh.target, 8, targets[i]);
      blocks_.push_back(fresh);
    }
    below += weights[i];
    // Entry k is for words up to its threshold: ceil(2^32 P) of them.
    const double words = std::ceil(below / sum * 0x1p32);
    blocks_.back().threshold[k % 8] = static_cast<std::uint32_t>(std::clamp(words, 1.0, 0x1p32) - 1.0);
    blocks_.back().target[k % 8] = targets[i];
    ++k;
  }
  if (k > 0) blocks_.back().threshold[(k - 1) % 8] = 0xFFFFFFFFU;
  first_.push_back(static_cast<std::uint32_t>(blocks_.size()));
}

std::shared_ptr<const JumpTables> make_jump_tables(const Network& network, const Voxels& voxels, Rows rows) {
  auto tables = std::make_shared<JumpTables>();
  const std::size_t stride = network.species();
  tables->of_species.resize(stride);
  tables->uniform_rate.assign(stride, 0.0);
  tables->leave_rate.assign(voxels.size() * stride, 0.0);
  sum_rates(network, voxels, *tables);
  const auto exits = sum_exchanges(network, voxels, *tables);
  // Without a flow and without exits, probabilities do not depend on the diffusivity.
  std::map<std::tuple<const JumpGraph*, double, int>, std::shared_ptr<const JumpTable>> known;
  for (std::size_t s = 0; s < stride; ++s) {
    const int species = static_cast<int>(s);
    const JumpGraph* graph = network.stochastic(species) ? graph_of(network, voxels, species) : nullptr;
    double largest = 0;
    for (std::size_t at = s; at < tables->leave_rate.size(); at += stride)
      largest = std::max(largest, tables->leave_rate[at]);
    if (largest == 0) continue;
    if (rows == Rows::uniform) tables->uniform_rate[s] = largest;
    const double kappa = network.diffusivity(species);
    const bool shared = exits[s].empty() && graph && graph->flow.empty();
    auto& table = known[{graph, shared ? -1.0 : kappa, exits[s].empty() ? -1 : species}];
    if (!table) table = make_table(voxels, graph, kappa, tables->uniform_rate[s], exits[s]);
    tables->of_species[s] = table;
  }
  return tables;
}

}  // namespace shmoo::rdme
