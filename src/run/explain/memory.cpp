#include "run/explain/memory.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

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

std::size_t program_bytes() {
  malloc_trim(0);
  return resident_bytes() - std::min(resident_bytes(), heap_bytes());
}

namespace {

std::size_t highest_resident_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace

Peak::Peak() {
  malloc_trim(0);  // freed pages are to count when they are used again
  std::ofstream mark("/proc/self/clear_refs");
  mark << 5 << std::flush;
  marked_ = mark.good();
  start_ = resident_bytes();
}

std::size_t Peak::bytes() const {
  return std::max(start_, marked_ ? highest_resident_bytes() : resident_bytes()) - start_;
}

double Peak::held() const { return double(resident_bytes()) - double(start_); }

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
  constexpr double buffers = 2e6, a_value = 85;    // measured with HDF5 1.10
  constexpr double cache = 16u << 20, number = 8;  // of a dataset (hdf5_data.cpp)
  double largest = 0;
  for (const auto& info : layout.fields) {
    const double values = double(cells(info) * layout.times.size());
    largest = std::max(largest, info.shared ? std::min(cache, number * values) : a_value * values);
  }
  return buffers + largest;
}

}  // namespace shmoo::run
