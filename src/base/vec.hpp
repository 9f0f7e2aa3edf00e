#pragma once
// Small fixed-size vectors of a D-dimensional space, D = 1, 2, 3.
#include <Eigen/Core>

namespace shmoo::base {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

template <int D>
using Mat = Eigen::Matrix<double, D, D>;

}  // namespace shmoo::base
