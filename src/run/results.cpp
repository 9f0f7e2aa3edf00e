#include "run/results.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace shmoo::run {
namespace {

template <class Number>
void write_account(const rdme::Account<Number>& account, Number* row) {
  row[0] = account.initial, row[1] = account.created, row[2] = account.destroyed, row[3] = account.entered,
  row[4] = account.left;
}

}  // namespace

Results::Results(coupling::RecordLayout record_layout, std::size_t species_count, std::size_t realisations)
    : layout(std::move(record_layout)),
      species(species_count),
      done(realisations, 0),
      shared_fields(layout.fields.size()),
      shared_observables(layout.observables.size()),
      counts(realisations * species * ledger_kinds, 0),
      amounts(realisations * species * ledger_kinds, 0.0),
      balanced(realisations, 0),
      reaction_events(realisations, 0),
      jump_events(realisations, 0) {
  for (const auto& info : layout.fields) {
    const Block empty{base::ExactSums(cells(info)), base::SparseHistograms(cells(info))};
    blocks.emplace_back(info.shared ? 0 : layout.times.size(), empty);
  }
  for (const auto& info : layout.observables) {
    const auto size = info.shared ? 0 : realisations * layout.times.size() * cells(info);
    values.emplace_back(size, std::numeric_limits<double>::quiet_NaN());
  }
}

std::size_t Results::done_count() const {
  return static_cast<std::size_t>(std::count(done.begin(), done.end(), std::uint8_t{1}));
}

void Results::merge(const Results& part) {
  const auto take = [](std::vector<double>& known, const std::vector<double>& came) {
    if (known.empty()) known = came;
  };
  for (std::size_t f = 0; f < blocks.size(); ++f) {
    take(shared_fields[f], part.shared_fields[f]);
    for (std::size_t t = 0; t < blocks[f].size(); ++t) {
      blocks[f][t].sums.merge(part.blocks[f][t].sums);
      blocks[f][t].histograms.merge(part.blocks[f][t].histograms);
    }
  }
  for (std::size_t o = 0; o < values.size(); ++o) take(shared_observables[o], part.shared_observables[o]);
  const auto copy_row = [](const auto& from, auto& to, std::size_t k, std::size_t rows) {
    const auto width = static_cast<std::ptrdiff_t>(to.size() / rows), at = static_cast<std::ptrdiff_t>(k) * width;
    std::copy_n(from.begin() + at, width, to.begin() + at);
  };
  for (std::size_t k = 0; k < done.size(); ++k) {
    if (part.done[k] == 0) continue;
    for (std::size_t o = 0; o < values.size(); ++o) copy_row(part.values[o], values[o], k, done.size());
    copy_row(part.counts, counts, k, done.size());
    copy_row(part.amounts, amounts, k, done.size());
    balanced[k] = part.balanced[k];
    reaction_events[k] = part.reaction_events[k];
    jump_events[k] = part.jump_events[k];
    done[k] = 1;
  }
}

Collector::Collector(Results& results) : results_(results) {
  const auto locks = results.layout.fields.size() * results.layout.times.size();
  for (std::size_t i = 0; i < locks; ++i) block_locks_.push_back(std::make_unique<std::mutex>());
}

void Collector::share(Recorder& recorded) {
  const auto take = [](std::vector<double>& known, std::vector<double>& came) {
    if (known.empty()) known = std::move(came);
  };
  const std::unique_lock lock(adding_);
  for (std::size_t f = 0; f < recorded.shared_fields.size(); ++f)
    take(results_.shared_fields[f], recorded.shared_fields[f]);
  for (std::size_t o = 0; o < recorded.observables.size(); ++o) {
    if (results_.layout.observables[o].shared) take(results_.shared_observables[o], recorded.observables[o]);
  }
}

void Collector::add(std::uint32_t k, const Recorder& recorded, const coupling::Outcome& outcome) {
  const std::shared_lock lock(adding_);
  const auto times = results_.layout.times.size();
  // Threads that finish together begin at different blocks.
  for (std::size_t i = 0; i < block_locks_.size(); ++i) {
    const auto b = (i + k) % block_locks_.size();
    const auto f = b / times, t = b % times;
    if (results_.blocks[f].empty()) continue;
    const auto size = cells(results_.layout.fields[f]);
    const auto sample = std::span(recorded.varying_fields[f]).subspan(t * size, size);
    const std::scoped_lock block_lock(*block_locks_[b]);
    results_.blocks[f][t].sums.add(sample);
    results_.blocks[f][t].histograms.add(sample);
  }
  for (std::size_t o = 0; o < results_.values.size(); ++o) {
    if (results_.values[o].empty()) continue;
    const auto& from = recorded.observables[o];
    std::copy(from.begin(), from.end(), results_.values[o].begin() + static_cast<std::ptrdiff_t>(k * from.size()));
  }
  for (std::size_t s = 0; s < results_.species; ++s) {
    const auto row = (k * results_.species + s) * ledger_kinds;
    if (s < outcome.ledger.counts.size()) write_account(outcome.ledger.counts[s], &results_.counts[row]);
    if (s < outcome.ledger.amounts.size()) write_account(outcome.ledger.amounts[s], &results_.amounts[row]);
  }
  results_.balanced[k] = outcome.balanced;
  results_.reaction_events[k] = outcome.reaction_events;
  results_.jump_events[k] = outcome.jump_events;
  results_.done[k] = 1;
}

}  // namespace shmoo::run
