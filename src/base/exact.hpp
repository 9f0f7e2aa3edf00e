#pragma once
// Exact statistics: sums and histograms that are the same to the bit in whatever order, and however divided, their
// samples come, because they only ever add whole numbers. A real value is first rounded to a multiple of a fixed
// quantum.
#include <cstdint>
#include <span>
#include <vector>

namespace shmoo::base {

__extension__ using Int128 = __int128;

inline constexpr std::int64_t exact_limit = std::int64_t{1} << 53;  // a sample's magnitude stays below this
inline constexpr std::int64_t sample_limit = (1 << 19) - 1;         // the most samples that one statistic takes

// Real numbers as multiples of a quantum: the power of two next above scale, times 2^-38. Magnitudes up to 2^15 scale.
class FixedPoint {
 public:
  explicit FixedPoint(double scale);  // typical magnitude, > 0 and finite; else std::invalid_argument
  static FixedPoint whole();          // the quantum 1

  double quantum() const { return quantum_; }
  // Rounds half away from zero. std::range_error for what is not finite or too large.
  std::int64_t operator()(double value) const;

 private:
  FixedPoint() = default;
  double quantum_ = 1.0;
};

// Sums of x and x^2 for many cells, which all receive the same number of samples.
class ExactSums {
 public:
  explicit ExactSums(std::size_t cells = 0) : sum_(cells), squares_(cells) {}

  void add(std::span<const std::int64_t>
               sample);  // std::range_error where a magnitude reaches exact_limit; then nothing is added
  void merge(const ExactSums& other);

  std::size_t cells() const { return sum_.size(); }
  std::int64_t samples() const { return samples_; }
  double mean(std::size_t cell) const;      // NaN without samples
  double variance(std::size_t cell) const;  // unbiased, NaN below two samples

  // The exact state, for files: each 128-bit sum as two words, low then high.
  std::vector<std::uint64_t> sum_words() const;
  std::vector<std::uint64_t> square_words() const;
  static ExactSums from_words(std::int64_t samples, std::span<const std::uint64_t> sum,
                              std::span<const std::uint64_t> squares);

  std::size_t bytes() const { return (sum_.capacity() + squares_.capacity()) * sizeof(Int128); }

 private:
  std::int64_t samples_ = 0;
  std::vector<Int128> sum_, squares_;
};

// Bins of whole numbers: width 1 below 128 in magnitude, then 64 bins per octave (width at most value/64).
namespace bins {
std::uint16_t of(std::int64_t value);  // monotone; |value| < exact_limit
double middle(std::uint16_t bin);      // of the whole numbers in the bin
double width(std::uint16_t bin);       // how many they are
}  // namespace bins

// Histograms over `bins` for many cells, stored sparsely: 4 bytes per cell and bin that holds something.
class SparseHistograms {
 public:
  explicit SparseHistograms(std::size_t cells = 0) : first_(cells + 1, 0) {}

  void add(std::span<const std::int64_t> sample);  // one value per cell
  void merge(const SparseHistograms& other);

  std::size_t cells() const { return first_.size() - 1; }
  std::int64_t samples() const { return samples_; }
  // The bin of the smallest x with at least a fraction q of the samples <= x. Needs samples() > 0.
  std::uint16_t quantile_bin(std::size_t cell, double q) const;
  double quantile(std::size_t cell, double q) const { return bins::middle(quantile_bin(cell, q)); }

  // The exact state, for files: entries of cell c are [first[c], first[c+1]), each bin << 19 | count, ascending.
  std::span<const std::uint32_t> first() const { return first_; }
  std::span<const std::uint32_t> entries() const { return entries_; }
  static SparseHistograms from_arrays(std::int64_t samples, std::vector<std::uint32_t> first,
                                      std::vector<std::uint32_t> entries);

  std::size_t bytes() const { return (first_.capacity() + entries_.capacity()) * sizeof(std::uint32_t); }

 private:
  void check_samples(std::int64_t more) const;

  std::int64_t samples_ = 0;
  std::vector<std::uint32_t> first_, entries_;
};

}  // namespace shmoo::base
