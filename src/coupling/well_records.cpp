#include "coupling/well_records.hpp"

#include <algorithm>

namespace shmoo::coupling {

WellRecords::WellRecords(const scene::Scene& scene, const rdme::Network& network, std::vector<double> times,
                         bool shared)
    : network_(network) {
  layout_.times = std::move(times);
  add_fields(scene, shared);
  add_observables(scene, shared);
}

void WellRecords::add_fields(const scene::Scene& scene, bool shared) {
  const auto& wanted = scene.run.record;
  for (std::size_t s = 0; s < scene.species.size(); ++s) {
    const auto& name = scene.species[s].name;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    field_species_.push_back(static_cast<int>(s));
    layout_.fields.push_back({name, "molecules", network_.stochastic(int(s)), shared, {1}, 1e6, {}});
  }
}

bool WellRecords::taken(const std::string& observable) const {
  const auto same = [&](const FieldInfo& info) { return info.name == observable; };
  return std::any_of(layout_.observables.begin(), layout_.observables.end(), same);
}

void WellRecords::add_observables(const scene::Scene& scene, bool shared) {
  for (const auto& one : scene.observables) {
    const bool count = one.type == scene::ObservableType::count;
    const auto& species = scene.species[std::size_t(one.species)];
    const double volume = scene.compartments[std::size_t(species.compartment)].volume;
    counts_.push_back({one.species, count ? 1.0 : 1.0 / volume});
    const bool whole = count && network_.stochastic(one.species);
    layout_.observables.push_back(
        {one.name, count ? "molecules" : "molecules/m^3", whole, shared, {}, count ? 1e6 : 1e6 / volume, {}});
  }
  const auto add = [&](const std::string& name, const std::string& formula) {
    if (taken(name)) return;
    layout_.observables.push_back({name, "1", false, shared, {}, 1.0, {}});
    formulas_.push_back(formula);
  };
  for (const auto& one : scene.definitions) add(one.name, one.expression);
  for (const int varying : network_.varying()) {
    const auto& name = network_.parameters()[std::size_t(varying)].first;
    add(name, name);
  }
}

WellRecords::Reader::Reader(const WellRecords& records) : records_(records) {
  for (const auto& formula : records.formulas_) formulas_.emplace_back(formula, expression_names(records.network_));
}

void WellRecords::Reader::read(std::size_t time, const rdme::State& state, RecordSink& sink) {
  const auto& network = records_.network_;
  const auto send = [&](int species, double factor, bool whole, const auto& to) {
    const auto s = std::size_t(species);
    const double amount = network.stochastic(species) ? double(state.count[s]) : state.amount[s];
    const double value = factor * amount;
    if (whole)
      to(Values(std::span<const std::int64_t>(&state.count[s], 1)));
    else
      to(Values(std::span<const double>(&value, 1)));
  };
  for (std::size_t f = 0; f < records_.field_species_.size(); ++f)
    send(records_.field_species_[f], 1.0, records_.layout_.fields[f].whole,
         [&](Values values) { sink.field(time, f, values); });
  const auto& observables = records_.layout_.observables;
  for (std::size_t o = 0; o < records_.counts_.size(); ++o)
    send(records_.counts_[o].species, records_.counts_[o].per_volume, observables[o].whole,
         [&](Values values) { sink.observable(time, o, values); });
  for (std::size_t k = 0; k < formulas_.size(); ++k) {
    const double value = rdme::value_at(formulas_[k], network, state, records_.layout_.times[time]);
    sink.observable(time, records_.counts_.size() + k, Values(std::span<const double>(&value, 1)));
  }
}

}  // namespace shmoo::coupling
