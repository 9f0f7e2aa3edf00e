#include "rdme/laws.hpp"

#include <algorithm>

namespace shmoo::rdme {

Laws::Laws(const Network& network, Treatment of) {
  for (const Reaction& reaction : network.reactions()) {
    Law law;
    law.constant = reaction.rate_constant;
    law.order = reaction.order;
    law.first = static_cast<std::uint32_t>(factors.size());
    for (const scene::Term& term : reaction.reactants) {
      int taken = 0;
      for (const Change& change : reaction.changes) {
        if (change.species == term.species) taken = std::max(0, -change.amount);
      }
      const bool beyond = reaction.on_surface() && !network.lives_in(term.species, reaction.surface[0]);
      factors.push_back({term.species, term.count, network.stochastic(term.species), taken, beyond});
      if (!beyond) law.own_order += term.count;
    }
    law.surface = reaction.on_surface();
    law.last = static_cast<std::uint32_t>(factors.size());
    if (!reaction.expression.empty() && reaction.treatment() == of) {
      law.expression = static_cast<int>(expressions.size());
      expressions.emplace_back(reaction.expression, expression_names(network));
      if (reaction.reads_time) {
        law.timed = static_cast<int>(timed.size());
        timed.emplace_back(reaction.expression, expression_names(network));
      }
    }
    law.simple = law.expression < 0 && !law.surface;
    of_reaction.push_back(law);
  }
}

void Laws::set_parameters(const Network& network, const double* values) {
  if (network.varying().empty()) return;
  const auto set = [&](Expression& one) {
    for (std::size_t v = 0; v < network.varying().size(); ++v)
      one.set_parameter(static_cast<std::size_t>(network.varying()[v]), values[v]);
  };
  for (Expression& one : expressions) set(one);
  for (TimedRate& one : timed) one.prepare(set);
}

}  // namespace shmoo::rdme
