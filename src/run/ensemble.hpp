#pragma once
// Runs the realisations of an experiment over threads into one result file.
#include <cstdint>
#include <filesystem>
#include <string>

#include "coupling/experiment.hpp"
#include "run/progress_bar.hpp"

namespace shmoo::run {

struct EnsembleOptions {
  std::filesystem::path output;
  std::uint32_t realisations = 1;
  int threads = 1;
  std::uint32_t part = 0, parts = 1;  // realise only k with k modulo parts == part
  bool resume = false;                // go on from the finished realisations that `output` holds
  double write_interval = 10;         // [s] of wall time between two writes, at least; longer where writing is slow
  ProgressBar::Style progress = ProgressBar::Style::quiet;
  std::string command{};  // for /provenance
};

struct EnsembleEnd {
  bool interrupted = false;
  std::size_t done = 0, wanted = 0;  // of all parts
  bool balanced = true;              // the ledger of every finished realisation
  double seconds = 0;                // wall time
};

// The result is the same to the bit for any number of threads and any division into sessions. The file is written
// before the first realisation, then after finished ones, and at the end. base::InputError where `output` cannot be
// resumed from, base::RunError where a realisation fails (status "failed"; the finished ones are kept) or the file
// cannot be written.
EnsembleEnd run_ensemble(coupling::Experiment& experiment, const EnsembleOptions& options);

// base::InputError where a file cannot be written at `output`.
void require_writable(const std::filesystem::path& output);

}  // namespace shmoo::run
