#include "rdme/samplers/leap_condition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shmoo::rdme {
namespace {

constexpr double least_events = 10;  // of a reaction that leaps, until a reactant is used up
constexpr int order_of_custom_law = 4;

}  // namespace

double LeapCondition::Reader::g(double n) const {
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += n > k ? n / (n - k) : 1.0;
  return order * sum / count;
}

LeapCondition::LeapCondition(const Network& network, double tolerance)
    : network_(network),
      tolerance_(tolerance),
      readers_(network.species()),
      drift_(network.species(), 0.0),
      spread_(network.species(), 0.0) {
  const auto add = [&](int species, Reader reader) {
    auto& known = readers_[species];
    const auto same = [&](const Reader& one) { return one.order == reader.order && one.count == reader.count; };
    if (std::ranges::none_of(known, same)) known.push_back(reader);
  };
  for (const Reaction& reaction : network.reactions()) {
    if (!reaction.stochastic) continue;
    if (reaction.expression.empty()) {
      for (const scene::Term& term : reaction.reactants) add(term.species, {reaction.order, term.count});
    } else {
      for (const int species : reaction.reads) add(species, {order_of_custom_law, 1});
    }
  }
}

double LeapCondition::number(const State& state, std::size_t voxel, int species) const {
  const std::size_t at = voxel * state.species + species;
  return network_.stochastic(species) ? static_cast<double>(state.count[at]) : std::max(0.0, state.amount[at]);
}

bool LeapCondition::critical(int reaction, const State& state, std::size_t voxel) const {
  for (const Change& change : network_.reactions()[reaction].changes) {
    if (number(state, voxel, change.species) < -least_events * change.amount) return true;
  }
  return false;
}

double LeapCondition::longest(std::span<const int> leaping, std::span<const double> rate, const State& state,
                              std::size_t voxel) {
  for (const int r : leaping) {
    for (const Change& change : network_.reactions()[r].changes) {
      drift_[change.species] += change.amount * rate[r];
      spread_[change.species] += double(change.amount) * change.amount * rate[r];
    }
  }
  double tau = std::numeric_limits<double>::infinity();
  for (const int r : leaping) {
    for (const Change& change : network_.reactions()[r].changes) {
      const int s = change.species;
      const double mu = std::abs(drift_[s]), sigma2 = spread_[s];
      drift_[s] = spread_[s] = 0;  // clean for the next call, and done with
      if (sigma2 == 0 || readers_[s].empty()) continue;
      const double n = number(state, voxel, s);
      double g = 0;
      for (const Reader& reader : readers_[s]) g = std::max(g, reader.g(n));
      const double allowed = std::max(tolerance_ * n / g, 1.0);
      tau = std::min({tau, allowed / mu, allowed * allowed / sigma2});
    }
  }
  return tau;
}

}  // namespace shmoo::rdme
