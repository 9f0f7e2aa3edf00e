#pragma once
// All that the finished realisations of one experiment gave, in memory. Adding a realisation commutes to the bit.
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <vector>

#include "base/exact.hpp"
#include "coupling/experiment.hpp"
#include "run/recorder.hpp"

namespace shmoo::run {

struct Block {  // one varying field at one time
  base::ExactSums sums;
  base::SparseHistograms histograms;
};

inline constexpr std::size_t ledger_kinds = 5;  // initial, created, destroyed, entered, left

struct Results {
  Results(coupling::RecordLayout record_layout, std::size_t species_count, std::size_t realisations);

  std::size_t done_count() const;
  // Takes over the finished realisations of a part with the same layout, none of which may be done here.
  void merge(const Results& part);
  bool complete() const { return done_count() == done.size(); }

  coupling::RecordLayout layout;
  std::size_t species;
  std::vector<std::uint8_t> done;                       // [realisation]
  std::vector<std::vector<double>> shared_fields;       // [field][time * cells]; empty for varying fields
  std::vector<std::vector<double>> shared_observables;  // [observable][time * cells]
  std::vector<std::vector<Block>> blocks;               // [field][time]; empty for shared fields
  std::vector<std::vector<double>> values;              // [observable][realisation * time * cells], NaN until done
  std::vector<std::int64_t> counts;                     // [realisation * species * ledger_kinds], stochastic species
  std::vector<double> amounts;                          // the same, deterministic species [molecules]
  std::vector<std::uint8_t> balanced;                   // [realisation]
  std::vector<std::uint64_t> reaction_events, jump_events;  // [realisation]
};

// Results that many threads add to.
class Collector {
 public:
  explicit Collector(Results& results);

  // Takes what all realisations share out of the recorder, unless it is known. Thread-safe.
  void share(Recorder& recorded);

  // Adds realisation k. Thread-safe.
  void add(std::uint32_t k, const Recorder& recorded, const coupling::Outcome& outcome);

  // Calls `look` while nothing is being added.
  template <class Look>
  void at_rest(Look&& look) {
    const std::unique_lock lock(adding_);
    look(const_cast<const Results&>(results_));
  }

 private:
  Results& results_;
  std::shared_mutex adding_;                              // shared: adds; exclusive: looks
  std::vector<std::unique_ptr<std::mutex>> block_locks_;  // one per field and time
};

}  // namespace shmoo::run
