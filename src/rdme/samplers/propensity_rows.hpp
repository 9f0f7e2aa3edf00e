#pragma once
// The propensities of all voxels' reactions, with sums over blocks of eight, so that a total and a pick among hundreds
// of reactions look at tens of numbers. Sums are always made anew from what they sum: round-off cannot drift.
#include <cstdint>
#include <vector>

namespace shmoo::rdme {

class PropensityRows {
 public:
  void clear(std::size_t voxels, std::size_t reactions) {
    blocks_ = (reactions + width - 1) / width;
    stride_ = blocks_ > 1 ? blocks_ * width : reactions;
    reactions_ = reactions;
    value_.assign(voxels * stride_, 0.0);
    sum_.assign(blocks_ > 1 ? voxels * blocks_ : 0, 0.0);
  }

  // `value` [1/s], finite and >= 0
  void set(std::size_t voxel, std::size_t reaction, double value) {
    double* const row = value_.data() + voxel * stride_;
    row[reaction] = value;
    if (blocks_ <= 1) return;
    const std::size_t block = reaction / width;
    sum_[voxel * blocks_ + block] = add(row + block * width, width);
  }

  double value(std::size_t voxel, std::size_t reaction) const { return value_[voxel * stride_ + reaction]; }

  double total(std::size_t voxel) const {
    return blocks_ > 1 ? add(sum_.data() + voxel * blocks_, blocks_) : add(value_.data() + voxel * stride_, stride_);
  }

  // The reaction that holds `rest`, or where round-off has left none the number of reactions. Leaves in `rest` what is
  // beyond the reactions before it.
  std::size_t pick(std::size_t voxel, double& rest) const {
    const double* const row = value_.data() + voxel * stride_;
    std::size_t r = 0;
    if (blocks_ > 1) {
      const double* const sums = sum_.data() + voxel * blocks_;
      std::size_t block = 0;
      while (block < blocks_ && rest >= sums[block]) rest -= sums[block++];
      r = block * width;
    }
    while (r < reactions_ && rest >= row[r]) rest -= row[r++];
    return r < reactions_ ? r : reactions_;
  }

 private:
  static constexpr std::size_t width = 8;
  static double add(const double* values, std::size_t number) {
    double sum = 0.0;
    for (std::size_t k = 0; k < number; ++k) sum += values[k];
    return sum;
  }
  std::size_t reactions_ = 0, stride_ = 0, blocks_ = 0;
  std::vector<double> value_, sum_;
};

}  // namespace shmoo::rdme
