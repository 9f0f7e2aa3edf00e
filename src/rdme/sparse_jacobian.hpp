#pragma once
// A square matrix by compressed columns whose entries are given as a list, always in the same order: the order is
// learned once, later lists are summed into their places.
#include <cstdint>
#include <span>
#include <vector>

namespace shmoo::rdme {

struct Entry {
  std::uint32_t row = 0, column = 0;
  double value = 0;
};

class SparseJacobian {
 public:
  // Learns where the entries are; the diagonal is always present.
  void learn(std::size_t size, std::span<const Entry> entries);

  // The sums of entries that fall on the same place, as compressed columns.
  void fill(std::span<const Entry> entries, double* values) const;

  std::size_t size() const { return first_.size() - 1; }
  const std::vector<std::int64_t>& first() const { return first_; }  // [size + 1] by column
  const std::vector<std::int64_t>& row() const { return row_; }      // [entries]

  // Whether solving directly pays: factors are made by at most the work of `products` products with the matrix.
  bool factors_within(double products) const;

 private:
  std::vector<std::int64_t> first_, row_;
  std::vector<std::uint32_t> place_;  // of each entry of a list
};

}  // namespace shmoo::rdme
