#include "rdme/sparse_jacobian.hpp"

#include <suitesparse/klu.h>

#include <algorithm>

namespace shmoo::rdme {

void SparseJacobian::learn(std::size_t size, std::span<const Entry> entries) {
  std::vector<std::vector<std::uint32_t>> rows(size);
  for (std::uint32_t i = 0; i < size; ++i) rows[i].push_back(i);
  for (const Entry& entry : entries) rows[entry.column].push_back(entry.row);
  first_.assign(1, 0);
  row_.clear();
  for (auto& column : rows) {
    std::ranges::sort(column);
    column.erase(std::unique(column.begin(), column.end()), column.end());
    row_.insert(row_.end(), column.begin(), column.end());
    first_.push_back(static_cast<std::int64_t>(row_.size()));
  }
  place_.clear();
  for (const Entry& entry : entries) {
    const auto begin = row_.begin() + first_[entry.column], end = row_.begin() + first_[entry.column + 1];
    place_.push_back(static_cast<std::uint32_t>(std::lower_bound(begin, end, entry.row) - row_.begin()));
  }
}

void SparseJacobian::fill(std::span<const Entry> entries, double* values) const {
  std::fill_n(values, row_.size(), 0.0);
  for (std::size_t k = 0; k < entries.size(); ++k) values[place_[k]] += entries[k].value;
}

bool SparseJacobian::factors_within(double products) const {
  klu_l_common common;
  klu_l_defaults(&common);  // minimum degree, which tells its operations
  auto first = first_, row = row_;
  klu_l_symbolic* symbolic = klu_l_analyze(static_cast<std::int64_t>(size()), first.data(), row.data(), &common);
  if (!symbolic) return false;
  const bool pays = symbolic->est_flops <= 2.0 * products * static_cast<double>(row_.size());
  klu_l_free_symbolic(&symbolic, &common);
  return pays;
}

}  // namespace shmoo::rdme
