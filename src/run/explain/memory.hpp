#pragma once
// What this process holds, and what a run's records will.
#include <cstddef>
#include <functional>

#include "coupling/record.hpp"

namespace shmoo::run {

std::size_t heap_bytes();      // allocated and not freed
std::size_t resident_bytes();  // in memory, libraries included
std::size_t
program_bytes();  // in memory that is not allocated: the program and its libraries, as far as they were used

// The most that is in memory at a time beyond what there was at the start, counted in whole pages. Where the system
// cannot set its mark anew (Linux does in /proc/self/clear_refs), what there is when asked counts.
class Peak {
 public:
  Peak();
  std::size_t bytes() const;
  double held() const;  // what is there now beyond the start

 private:
  bool marked_;
  std::size_t start_;
};

// Of all finished realisations together (results.hpp). `filled(info)` is the part of a field's values that differ
// between realisations at all: a species' share of voxels.
using Filled = std::function<double(const coupling::FieldInfo&)>;
double results_bytes(const coupling::RecordLayout& layout, double realisations, const Filled& filled);

// Of what one realisation, or what all share, keeps until it has ended (recorder.hpp).
double recorder_bytes(const coupling::RecordLayout& layout, bool shared);

// Of the HDF5 library once something has been written, and of its buffers and caches while it writes.
constexpr double library_bytes = 5.7e6;  // measured with HDF5 1.10
double writing_bytes(const coupling::RecordLayout& layout);

}  // namespace shmoo::run
