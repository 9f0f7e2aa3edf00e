#include "run/explain/memory.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "run/recorder.hpp"

namespace shmoo::run {

std::size_t heap_bytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::size_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

double results_bytes(const coupling::RecordLayout& layout, double realisations, const Filled& filled) {
  // Two sums of 16 bytes, an offset, and the bins that hold something: one where all are alike, else about as many as a
  // count's deviation over the width of a bin makes (base/exact.hpp).
  constexpr double sums = 32, offset = 4, bin = 4, most_bins = 40;
  double bytes = 0;
  for (const auto& info : layout.fields) {
    const double values = double(cells(info) * layout.times.size());
    const double bins = 1.0 + filled(info) * (std::min(realisations, most_bins) - 1.0);
    bytes += values * (info.shared ? sizeof(double) : sums + offset + bin * bins);
  }
  for (const auto& info : layout.observables)
    bytes += double(cells(info) * layout.times.size() * sizeof(double)) * (info.shared ? 1.0 : realisations);
  return bytes;
}

double recorder_bytes(const coupling::RecordLayout& layout, bool shared) {
  std::size_t values = 0;
  for (const auto* list : {&layout.fields, &layout.observables})
    for (const auto& info : *list) values += info.shared == shared ? cells(info) : 0;
  return double(values * layout.times.size() * sizeof(double));
}

double writing_bytes(const coupling::RecordLayout& layout) {
  constexpr double library = 11e6, a_value = 85;  // measured with HDF5 1.10: caches of the datasets of one field
  double largest = 0;
  for (const auto& info : layout.fields)
    if (!info.shared) largest = std::max(largest, double(cells(info) * layout.times.size()));
  return library + a_value * largest;
}

}  // namespace shmoo::run
