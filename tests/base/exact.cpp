// The exact accumulators: any order and any division give the same bits, and the numbers agree with extended precision.
#include "base/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "base/random.hpp"

namespace shmoo::base {
namespace {

std::vector<std::vector<std::int64_t>> samples_of(std::size_t cells, std::size_t count, double offset, double spread) {
  std::vector<std::vector<std::int64_t>> samples(count, std::vector<std::int64_t>(cells));
  RandomSequence random({11, 0}, Stream::test);
  for (auto& sample : samples) {
    for (auto& value : sample) value = static_cast<std::int64_t>(std::llround(offset + spread * random.normal()));
  }
  return samples;
}

template <class Statistic>
Statistic added(const std::vector<std::vector<std::int64_t>>& samples, const std::vector<std::size_t>& order) {
  Statistic all(samples.front().size());
  for (const auto s : order) all.add(samples[s]);
  return all;
}

template <class Statistic>
Statistic merged(const std::vector<std::vector<std::int64_t>>& samples, const std::vector<std::size_t>& order,
                 std::size_t parts) {
  std::vector<Statistic> part(parts, Statistic(samples.front().size()));
  for (std::size_t i = 0; i < order.size(); ++i) part[i % parts].add(samples[order[i]]);
  Statistic all(samples.front().size());
  for (auto p = part.rbegin(); p != part.rend(); ++p) all.merge(*p);
  return all;
}

std::vector<std::size_t> shuffled(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomSequence random({12, 0}, Stream::test);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

TEST(ExactSums, AnyOrderAndAnySplitGiveTheSameBits) {
  const auto samples = samples_of(20, 101, 1e12, 3e14);
  std::vector<std::size_t> in_order(samples.size());
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  const auto a = added<ExactSums>(samples, in_order), b = added<ExactSums>(samples, shuffled(samples.size()));
  const auto c = merged<ExactSums>(samples, shuffled(samples.size()), 7);
  EXPECT_EQ(a.sum_words(), b.sum_words());
  EXPECT_EQ(a.square_words(), b.square_words());
  EXPECT_EQ(a.sum_words(), c.sum_words());
  EXPECT_EQ(a.square_words(), c.square_words());
  EXPECT_EQ(a.samples(), c.samples());
}

TEST(ExactSums, AgreeWithExtendedPrecisionEvenWhereTheSpreadIsTiny) {
  for (const auto& [offset, spread] :
       std::vector<std::pair<double, double>>{{0, 5}, {-100, 10}, {8e15, 3}, {-4e12, 1e9}}) {
    const auto samples = samples_of(5, 200, offset, spread);
    ExactSums sums(5);
    for (const auto& sample : samples) sums.add(sample);
    for (std::size_t cell = 0; cell < 5; ++cell) {
      long double mean = 0, squares = 0;
      for (const auto& sample : samples) mean += static_cast<long double>(sample[cell] - samples[0][cell]) / 200.0L;
      for (const auto& sample : samples) {
        const long double d = static_cast<long double>(sample[cell] - samples[0][cell]) - mean;
        squares += d * d;
      }
      mean += static_cast<long double>(samples[0][cell]);
      EXPECT_NEAR(sums.mean(cell), static_cast<double>(mean), 2e-16 * std::abs(static_cast<double>(mean)));
      EXPECT_NEAR(sums.variance(cell) / static_cast<double>(squares / 199.0L), 1.0, 1e-14);
    }
  }
}

TEST(ExactSums, LargestSamplesDoNotOverflow) {
  ExactSums sums(2);
  for (int i = 0; i < 1000; ++i)
    sums.add(std::vector<std::int64_t>{exact_limit - 1, i % 2 ? exact_limit - 1 : 1 - exact_limit});
  EXPECT_EQ(sums.variance(0), 0.0);
  EXPECT_NEAR(sums.variance(1) / (std::pow(static_cast<double>(exact_limit - 1), 2) * 1000.0 / 999.0), 1.0, 1e-15);
}

TEST(ExactSums, RefuseWhatTheyCannotHoldAndStayAsTheyWere) {
  ExactSums sums(2);
  EXPECT_THROW(sums.add(std::vector<std::int64_t>{1, exact_limit}), std::range_error);
  EXPECT_EQ(sums.sum_words(), ExactSums(2).sum_words());
  EXPECT_TRUE(std::isnan(sums.mean(0)));
  sums.add(std::vector<std::int64_t>{3, 4});
  EXPECT_EQ(sums.mean(1), 4.0);
  EXPECT_TRUE(std::isnan(sums.variance(1)));
}

TEST(ExactSums, WordsRestoreTheState) {
  const auto samples = samples_of(4, 30, -1e15, 1e14);
  const auto half = added<ExactSums>({samples.begin(), samples.begin() + 15}, shuffled(15));
  auto again = ExactSums::from_words(half.samples(), half.sum_words(), half.square_words());
  for (std::size_t s = 15; s < 30; ++s) again.add(samples[s]);
  const auto whole = added<ExactSums>(samples, shuffled(30));
  EXPECT_EQ(again.sum_words(), whole.sum_words());
  EXPECT_EQ(again.square_words(), whole.square_words());
}

TEST(FixedPoint, RoundsToItsQuantumAndReportsTheRest) {
  const FixedPoint fixed(3e-4);
  EXPECT_LT(fixed.quantum(), 3e-4 * 8e-12);
  for (const double x : {0.0, 1e-4, -2.5e-4, 7.77e-3, 3e-4 * 32000}) {
    EXPECT_NEAR(static_cast<double>(fixed(x)) * fixed.quantum(), x, 0.5 * fixed.quantum());
  }
  EXPECT_THROW(fixed(std::numeric_limits<double>::quiet_NaN()), std::range_error);
  EXPECT_THROW(fixed(std::numeric_limits<double>::infinity()), std::range_error);
  EXPECT_THROW(fixed(3e-4 * 1e5), std::range_error);
  EXPECT_THROW(FixedPoint(0.0), std::invalid_argument);
  EXPECT_EQ(FixedPoint::whole()(41.0), 41);
}

TEST(Bins, HoldTheirValuesAscendAndKeepTheStatedWidth) {
  std::uint16_t last = 0;
  for (std::int64_t value = -70000; value <= 70000; ++value) {
    const auto bin = bins::of(value);
    ASSERT_GE(bin, last);
    ASSERT_LE(bin, last == 0 ? bin : last + 1);
    last = bin;
    ASSERT_LE(std::abs(bins::middle(bin) - static_cast<double>(value)), 0.5 * (bins::width(bin) - 1));
    ASSERT_LE(bins::width(bin), std::max(1.0, static_cast<double>(std::abs(value)) / 64.0));
  }
  for (const auto value : {exact_limit - 1, 1 - exact_limit}) EXPECT_LT(bins::of(value), 1 << 13);
}

TEST(SparseHistograms, AnyOrderAndAnySplitGiveTheSameEntries) {
  const auto samples = samples_of(9, 60, 300, 20);
  std::vector<std::size_t> in_order(samples.size());
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  const auto a = added<SparseHistograms>(samples, in_order);
  const auto b = merged<SparseHistograms>(samples, shuffled(samples.size()), 4);
  EXPECT_TRUE(std::ranges::equal(a.entries(), b.entries()));
  EXPECT_TRUE(std::ranges::equal(a.first(), b.first()));
  EXPECT_EQ(b.samples(), 60);
}

TEST(SparseHistograms, QuantilesAreTheSortedSamplesToAHalfBin) {
  const auto samples = samples_of(3, 20, 5000, 900);
  SparseHistograms histograms(3);
  for (const auto& sample : samples) histograms.add(sample);
  for (std::size_t cell = 0; cell < 3; ++cell) {
    std::vector<std::int64_t> sorted;
    for (const auto& sample : samples) sorted.push_back(sample[cell]);
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [q, index] :
         std::vector<std::pair<double, std::size_t>>{{0, 0}, {0.05, 0}, {0.5, 9}, {0.95, 18}, {1, 19}}) {
      const auto truth = static_cast<double>(sorted[index]);
      EXPECT_NEAR(histograms.quantile(cell, q), truth, 0.5 * truth / 64) << q;
    }
  }
}

TEST(SparseHistograms, SmallCountsAreExactAndRareBinsCostFourBytes) {
  SparseHistograms histograms(1000);
  for (int s = 0; s < 50; ++s) histograms.add(std::vector<std::int64_t>(1000, s % 5));
  EXPECT_EQ(histograms.quantile(7, 0.5), 2.0);
  EXPECT_LE(histograms.bytes(), 1001 * 4 + 5 * 1000 * 4);
}

}  // namespace
}  // namespace shmoo::base
