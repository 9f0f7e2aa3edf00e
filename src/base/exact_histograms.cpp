#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/exact.hpp"

namespace shmoo::base {
namespace bins {
namespace {

constexpr int octave_bits = 6;           // 2^6 bins per octave
constexpr std::uint16_t zero = 1 << 12;  // the bin of 0

struct Interval {
  std::int64_t lower, count;
};  // of magnitudes

Interval interval(std::uint16_t bin) {
  const int index = std::abs(static_cast<int>(bin) - zero);
  if (index < 2 << octave_bits) return {index, 1};
  const int shift = (index >> octave_bits) - 1;
  return {static_cast<std::int64_t>(index - (shift << octave_bits)) << shift, std::int64_t{1} << shift};
}

}  // namespace

std::uint16_t of(std::int64_t value) {
  const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
  const int shift = std::max(0, static_cast<int>(std::bit_width(magnitude)) - (octave_bits + 1));
  const int index = (shift << octave_bits) + static_cast<int>(magnitude >> shift);
  return static_cast<std::uint16_t>(value < 0 ? zero - index : zero + index);
}

double middle(std::uint16_t bin) {
  const auto [lower, count] = interval(bin);
  const double magnitude = static_cast<double>(lower) + 0.5 * static_cast<double>(count - 1);
  return bin < zero ? -magnitude : magnitude;
}

double width(std::uint16_t bin) { return static_cast<double>(interval(bin).count); }

}  // namespace bins

namespace {

constexpr int count_bits = 19;
constexpr std::uint32_t count_mask = (1u << count_bits) - 1;

std::uint32_t bin_of(std::uint32_t entry) { return entry >> count_bits; }

// Appends the union of two ascending lists of entries; counts of equal bins add up.
void unite(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, std::vector<std::uint32_t>& out) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (bin_of(a[i]) == bin_of(b[j]))
      out.push_back(a[i++] + (b[j++] & count_mask));
    else
      out.push_back(bin_of(a[i]) < bin_of(b[j]) ? a[i++] : b[j++]);
  }
  out.insert(out.end(), a.begin() + static_cast<std::ptrdiff_t>(i), a.end());
  out.insert(out.end(), b.begin() + static_cast<std::ptrdiff_t>(j), b.end());
}

}  // namespace

void SparseHistograms::check_samples(std::int64_t more) const {
  if (samples_ + more > sample_limit) throw std::range_error(fmt::format("more than {} samples", sample_limit));
}

void SparseHistograms::add(std::span<const std::int64_t> sample) {
  if (sample.size() != cells()) throw std::invalid_argument("a sample of another size than the histograms");
  SparseHistograms one(cells());
  one.samples_ = 1;
  one.entries_.resize(cells());
  for (std::size_t c = 0; c < cells(); ++c) {
    one.entries_[c] = static_cast<std::uint32_t>(bins::of(sample[c])) << count_bits | 1u;
    one.first_[c + 1] = static_cast<std::uint32_t>(c + 1);
  }
  merge(one);
}

void SparseHistograms::merge(const SparseHistograms& other) {
  if (other.cells() != cells()) throw std::invalid_argument("histograms of different sizes");
  check_samples(other.samples_);
  std::vector<std::uint32_t> united;
  united.reserve(entries_.size() + other.entries_.size());
  std::vector<std::uint32_t> first(first_.size(), 0);
  const auto row = [](const SparseHistograms& h, std::size_t c) {
    return std::span(h.entries_).subspan(h.first_[c], h.first_[c + 1] - h.first_[c]);
  };
  for (std::size_t c = 0; c < cells(); ++c) {
    unite(row(*this, c), row(other, c), united);
    if (united.size() > std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("histograms of more than 2^32 bins");
    first[c + 1] = static_cast<std::uint32_t>(united.size());
  }
  samples_ += other.samples_;
  first_ = std::move(first);
  united.shrink_to_fit();
  entries_ = std::move(united);
}

std::uint16_t SparseHistograms::quantile_bin(std::size_t cell, double q) const {
  const auto needed =
      q * static_cast<double>(samples_) * (1.0 - 1e-15);  // 0.95 * 20 must ask for 19, not for 19 + rounding
  std::int64_t below = 0;
  std::uint32_t entry = 0;
  for (auto e = first_[cell]; e < first_[cell + 1]; ++e) {
    entry = entries_[e];
    below += entry & count_mask;
    if (static_cast<double>(below) >= needed) break;
  }
  return static_cast<std::uint16_t>(bin_of(entry));
}

SparseHistograms SparseHistograms::from_arrays(std::int64_t samples, std::vector<std::uint32_t> first,
                                               std::vector<std::uint32_t> entries) {
  if (first.empty() || first.back() != entries.size())
    throw std::invalid_argument("histograms whose rows do not match");
  SparseHistograms out;
  out.samples_ = samples;
  out.first_ = std::move(first);
  out.entries_ = std::move(entries);
  return out;
}

}  // namespace shmoo::base
