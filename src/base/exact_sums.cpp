#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/exact.hpp"

namespace shmoo::base {
namespace {

constexpr int bits_below_scale = 38;

std::vector<std::uint64_t> words(const std::vector<Int128>& sums) {
  std::vector<std::uint64_t> out;
  out.reserve(2 * sums.size());
  for (const auto sum : sums) {
    out.push_back(static_cast<std::uint64_t>(sum));
    out.push_back(static_cast<std::uint64_t>(sum >> 64));
  }
  return out;
}

std::vector<Int128> sums(std::span<const std::uint64_t> words) {
  std::vector<Int128> out(words.size() / 2);
  for (std::size_t i = 0; i < out.size(); ++i) {
    __extension__ using Unsigned128 = unsigned __int128;
    out[i] = static_cast<Int128>(static_cast<Unsigned128>(words[2 * i + 1]) << 64 | words[2 * i]);
  }
  return out;
}

}  // namespace

FixedPoint::FixedPoint(double scale) {
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    throw std::invalid_argument(fmt::format("the scale of an exact sum is {}; it must be positive and finite", scale));
  }
  quantum_ = std::exp2(std::ceil(std::log2(scale)) - bits_below_scale);
}

FixedPoint FixedPoint::whole() { return FixedPoint(); }

std::int64_t FixedPoint::operator()(double value) const {
  const double multiple = std::round(value / quantum_);
  if (!(std::abs(multiple) < static_cast<double>(exact_limit))) {
    throw std::range_error(fmt::format("{} is {}, statistics take magnitudes below {:.3g}", value,
                                       std::isfinite(value) ? "too large" : "not a finite number",
                                       static_cast<double>(exact_limit) * quantum_));
  }
  return static_cast<std::int64_t>(multiple);
}

void ExactSums::add(std::span<const std::int64_t> sample) {
  if (sample.size() != cells()) throw std::invalid_argument("a sample of another size than the sums");
  if (samples_ >= sample_limit) throw std::range_error(fmt::format("more than {} samples", sample_limit));
  for (const auto value : sample) {
    if (value >= exact_limit || value <= -exact_limit)
      throw std::range_error(fmt::format("{} is too large for exact sums", value));
  }
  // At most 2^19 squares below 2^106: no sum can overflow.
  for (std::size_t i = 0; i < sample.size(); ++i) {
    sum_[i] += sample[i];
    squares_[i] += static_cast<Int128>(sample[i]) * sample[i];
  }
  ++samples_;
}

void ExactSums::merge(const ExactSums& other) {
  if (other.cells() != cells()) throw std::invalid_argument("sums of different sizes");
  if (samples_ + other.samples_ > sample_limit)
    throw std::range_error(fmt::format("more than {} samples", sample_limit));
  for (std::size_t i = 0; i < cells(); ++i) {
    sum_[i] += other.sum_[i];
    squares_[i] += other.squares_[i];
  }
  samples_ += other.samples_;
}

double ExactSums::mean(std::size_t cell) const {
  if (samples_ == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(static_cast<long double>(sum_[cell]) / static_cast<long double>(samples_));
}

double ExactSums::variance(std::size_t cell) const {
  if (samples_ < 2) return std::numeric_limits<double>::quiet_NaN();
  // With m and r the quotient and remainder of sum/n: the squares about m are squares - m sum - m r, exactly, and the
  // mean lies r/n beyond m. All terms stay below 2^126.
  const Int128 n = samples_;
  const Int128 m = sum_[cell] / n;
  const Int128 r = sum_[cell] - m * n;
  const Int128 about_m = squares_[cell] - m * sum_[cell] - m * r;
  const auto about_mean =
      static_cast<long double>(about_m) - static_cast<long double>(r * r) / static_cast<long double>(n);
  return static_cast<double>(about_mean / static_cast<long double>(n - 1));
}

std::vector<std::uint64_t> ExactSums::sum_words() const { return words(sum_); }
std::vector<std::uint64_t> ExactSums::square_words() const { return words(squares_); }

ExactSums ExactSums::from_words(std::int64_t samples, std::span<const std::uint64_t> sum,
                                std::span<const std::uint64_t> squares) {
  if (sum.size() != squares.size() || sum.size() % 2 != 0) throw std::invalid_argument("exact sums of different sizes");
  ExactSums out;
  out.samples_ = samples;
  out.sum_ = sums(sum);
  out.squares_ = sums(squares);
  return out;
}

}  // namespace shmoo::base
