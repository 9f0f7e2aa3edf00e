#include "rdme/jump_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

constexpr double jumps_that_pay = 30;  // of a voxel: finding so many one by one takes as long as listing its row

void check(double rate, const char* what, const std::string& species, std::size_t voxel) {
  if (rate >= 0 && std::isfinite(rate)) return;
  throw base::RunError(
      fmt::format("the {} rate of species {} in voxel {} is {} 1/s; it must be a finite number >= 0: look at the "
                  "diffusivity and at the volumes",
                  what, species, voxel, rate));
}

// Jumps of one species: written down in a graph, unlisted, or none.
struct Jumps {
  const JumpGraph* graph = nullptr;
  std::shared_ptr<const UnlistedJumps> unlisted;
  double kappa = 0;  // [m^2/s]

  Jumps(const Network& network, const Voxels& voxels, int species) {
    const int which = voxels.graph_of_species[species];
    if (which < 0 || !network.stochastic(species)) return;
    const auto at = static_cast<std::size_t>(which);
    kappa = network.diffusivity(species);
    if (kappa == 0 && voxels.graphs[at].flow.empty()) return;
    if (at < voxels.unlisted.size()) unlisted = voxels.unlisted[at];
    if (!unlisted) graph = &voxels.graphs[at];
  }
  explicit operator bool() const { return graph || unlisted; }

  double sum(const Voxels& voxels, std::size_t i, bool exact) const {  // [1/s] per molecule
    if (unlisted && !exact) return kappa * unlisted->sum(i);
    double sum = 0;
    std::vector<std::uint32_t> target;
    std::vector<double> rate;
    if (unlisted) row(voxels, i, target, rate);
    for (const double one : rate) sum += one;
    for (std::uint64_t p = graph ? graph->first[i] : 0; graph && p < graph->first[i + 1]; ++p)
      sum += jump_rate(*graph, p, kappa, voxels.volume[i]);
    return sum;
  }

  // Rates [1/s] of a row.
  void row(const Voxels& voxels, std::size_t i, std::vector<std::uint32_t>& target, std::vector<double>& rate) const {
    if (unlisted) {
      unlisted->row(static_cast<std::uint32_t>(i), target, rate);
      for (double& one : rate) one *= kappa;
    }
    for (std::uint64_t p = graph ? graph->first[i] : 0; graph && p < graph->first[i + 1]; ++p) {
      rate.push_back(jump_rate(*graph, p, kappa, voxels.volume[i]));
      target.push_back(graph->target[p]);
    }
  }
};

// `exact`: also of what is unlisted, whose bounds do otherwise.
void sum_rates(const Network& network, const Voxels& voxels, bool exact, JumpTables& tables) {
  const std::size_t stride = network.species();
  for (std::size_t s = 0; s < stride; ++s) {
    const int species = static_cast<int>(s);
    const Jumps jumps(network, voxels, species);
    for (std::size_t i = 0; jumps && i < voxels.size(); ++i) {
      const double sum = jumps.sum(voxels, i, exact);
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
std::shared_ptr<const JumpTable> make_table(const Voxels& voxels, const Jumps& jumps, double uniform,
                                            const std::map<std::uint32_t, double>& exits) {
  const std::size_t size = voxels.size();
  auto table = std::make_shared<JumpTable>(size, jumps.graph ? jumps.graph->target.size() : exits.size());
  std::vector<double> weights;
  std::vector<std::uint32_t> targets;
  for (std::size_t i = 0; i < size; ++i) {
    weights.clear();
    targets.clear();
    jumps.row(voxels, i, targets, weights);
    const auto add = [&](double weight, std::size_t target) {
      weights.push_back(weight);
      targets.push_back(static_cast<std::uint32_t>(target));
    };
    if (const auto exit = exits.find(static_cast<std::uint32_t>(i)); exit != exits.end()) add(exit->second, size);
    double sum = 0;
    for (const double weight : weights) sum += weight;
    if (uniform > sum * (1 + 1e-14)) add(uniform - sum, i);
    table->add_row(weights, targets);
  }
  table->add_row(std::vector<double>{1.0}, std::vector<std::uint32_t>{static_cast<std::uint32_t>(size)});
  return table;
}

std::shared_ptr<JumpTables> make_tables(const Network& network, const Voxels& voxels, Rows rows, bool list_all) {
  auto tables = std::make_shared<JumpTables>();
  const std::size_t stride = network.species();
  tables->of_species.resize(stride);
  tables->unlisted.resize(stride);
  tables->uniform_rate.assign(stride, 0.0);
  tables->leave_rate.assign(voxels.size() * stride, 0.0);
  sum_rates(network, voxels, list_all, *tables);
  const auto exits = sum_exchanges(network, voxels, *tables);
  // Without a flow and without exits, probabilities do not depend on the diffusivity.
  std::map<std::tuple<const void*, double, int>, std::shared_ptr<const JumpTable>> known;
  for (std::size_t s = 0; s < stride; ++s) {
    const int species = static_cast<int>(s);
    const Jumps jumps(network, voxels, species);
    double largest = 0;
    for (std::size_t at = s; at < tables->leave_rate.size(); at += stride)
      largest = std::max(largest, tables->leave_rate[at]);
    if (largest == 0) continue;
    if (rows == Rows::uniform) tables->uniform_rate[s] = largest;
    if (jumps.unlisted && exits[s].empty() && !list_all) {
      tables->unlisted[s] = jumps.unlisted;
      continue;
    }
    const bool shared = exits[s].empty() && jumps && (jumps.unlisted || jumps.graph->flow.empty());
    const void* const origin = jumps.unlisted ? static_cast<const void*>(jumps.unlisted.get()) : jumps.graph;
    auto& table = known[{origin, shared ? -1.0 : jumps.kappa, exits[s].empty() ? -1 : species}];
    if (!table) table = make_table(voxels, jumps, tables->uniform_rate[s], exits[s]);
    tables->of_species[s] = table;
  }
  return tables;
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
  return make_tables(network, voxels, rows, false);
}

std::shared_ptr<const JumpTables> with_rows_that_pay(std::shared_ptr<const JumpTables> tables, const Network& network,
                                                     const Voxels& voxels, const State& state, double dt, Rows rows) {
  double rate = 0;  // [1/s] of jumps that are found one by one
  for (std::size_t s = 0; s < tables->unlisted.size(); ++s) {
    for (std::size_t at = s; tables->unlisted[s] && at < state.count.size(); at += state.species)
      rate += tables->leave_rate[at] * static_cast<double>(state.count[at]);
  }
  if (rate * dt <= jumps_that_pay * static_cast<double>(voxels.size())) return tables;
  const std::lock_guard lock(tables->mutex);
  if (!tables->listed) tables->listed = make_tables(network, voxels, rows, true);
  return tables->listed;
}

}  // namespace shmoo::rdme
