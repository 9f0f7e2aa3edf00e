// What a flow tells about itself. Sums run in the order of the store, so they do not depend on threads.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/fluid.hpp"

namespace shmoo::hydro {

template <int D>
double Fluid<D>::kinetic_energy() const {
  double sum = 0.0;
  for (const std::uint32_t i : state_.rows.fluid()) sum += state_.share_of(i) * state_.velocity[i].squaredNorm();
  return 0.5 * state_.scales.mass * state_.scales.depth * sum;
}

template <int D>
double Fluid<D>::max_speed() const {
  double largest = 0.0;
  for (const std::uint32_t i : state_.rows.fluid()) largest = std::max(largest, state_.velocity[i].squaredNorm());
  return std::sqrt(largest);
}

template <int D>
base::Vec<D> Fluid<D>::momentum() const {
  Vec sum = Vec::Zero();
  for (const std::uint32_t i : state_.rows.fluid()) sum += state_.share_of(i) * state_.velocity[i];
  return state_.scales.mass * state_.scales.depth * sum;
}

template <int D>
double Fluid<D>::temperature() const {
  const auto& fluid = state_.rows.fluid();
  if (fluid.size() < 2) return 0.0;
  Vec mean = Vec::Zero();
  for (const std::uint32_t i : fluid) mean += state_.velocity[i];
  mean /= double(fluid.size());
  double sum = 0.0;
  for (const std::uint32_t i : fluid) sum += (state_.velocity[i] - mean).squaredNorm();
  return state_.scales.mass * state_.scales.depth * sum / (D * double(fluid.size() - 1));
}

template <int D>
double Fluid<D>::density_error() const {
  double largest = 0.0;
  for (const std::uint32_t i : state_.rows.fluid()) {
    largest = std::max(largest, std::abs(state_.density[i] / state_.scales.density - 1.0));
  }
  return largest;
}

template <int D>
double Fluid<D>::smallest_distance() const {
  double smallest = std::numeric_limits<double>::infinity();
  // The square of the mean of two particles' spacings, over that of the coarse ones.
  const auto relative_area = [&](std::size_t i, std::size_t j) {
    if (!state_.share) return 1.0;
    const double mean = 0.5 * (state_.spacing(i) + state_.spacing(j)) / state_.scales.spacing;
    return mean * mean;
  };
  const auto& blocks = state_.rows.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    for (std::uint32_t k = 0; k < block.partners; ++k) {
      const std::size_t j = blocks.particle(std::size_t(blocks.partners(block)[k]));
      for (std::size_t i = block.first; j < blocks.fluid() && i < block.first + block.size; ++i) {
        if (i != j) smallest = std::min(smallest, state_.separation(i, j).squaredNorm() / relative_area(i, j));
      }
    }
  }
  return std::sqrt(smallest) / state_.scales.spacing;
}

template <int D>
void Fluid<D>::begin_interval() {
  interval_ = 0.0;
  if (open_) open_->begin_interval();
  state_.mean_velocity = &state_.particles.template require<Vec>("mean_velocity", "m");
  if (state_.shift) state_.mean_shift = &state_.particles.template require<Vec>("mean_shift", "m");
  for (auto* column : {state_.mean_velocity, state_.mean_shift}) {
    if (column) std::fill(column->values().begin(), column->values().end(), Vec(Vec::Zero()));
  }
}

template <int D>
base::Vec<D> Fluid<D>::mean_velocity(std::size_t index) const {
  if (!(interval_ > 0.0) || !state_.mean_velocity) return Vec::Zero();
  return (*state_.mean_velocity)[index] / interval_;
}

template <int D>
base::Vec<D> Fluid<D>::mean_shift(std::size_t index) const {
  if (!(interval_ > 0.0) || !state_.mean_shift) return Vec::Zero();
  return (*state_.mean_shift)[index] / interval_;
}

template <int D>
base::Vec<D> Fluid<D>::velocity(std::size_t index) const {
  return state_.particles.role[index] == sph::Role::fluid ? state_.velocity[index] : (*state_.wall_velocity)[index];
}

template class Fluid<2>;
template class Fluid<3>;

}  // namespace shmoo::hydro
