// The Jacobian of the rate equations, entry by entry, from the same slopes as its products.
#include "rdme/rate_system.hpp"

namespace shmoo::rdme {

void RateSystem::transport_entries(std::vector<Entry>& entries) const {
  const std::size_t stride = species_.size();
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    entries.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), value});
  };
  for (std::size_t d = 0; d < stride; ++d) {
    const JumpGraph* const graph = rows_[d].graph;
    for (std::size_t i = 0; graph && i < voxels_->size(); ++i) {
      for (std::uint64_t p = graph->first[i]; p < graph->first[i + 1]; ++p) {
        add(graph->target[p] * stride + d, i * stride + d, rows_[d].rate[p]);
        add(i * stride + d, i * stride + d, -rows_[d].rate[p]);
      }
    }
  }
  for (const Exchange& exchange : voxels_->exchanges) {
    const int d = place_of_[exchange.species];
    if (d < 0) continue;
    const std::size_t at = exchange.voxel * stride + d;
    add(at, at, -exchange.exit_rate);
    add(unknowns() + left * stride + d, at, exchange.exit_rate);
  }
}

void RateSystem::jacobian(double t, const double* y, std::vector<Entry>& entries) {
  entries.clear();
  if (diffusion_) transport_entries(entries);
  if (!reactions_) return;
  const std::size_t stride = species_.size();
  direction_.assign(unknowns(), 0.0);
  for (Expression& expression : laws_.expressions) expression.set_time(t);
  laws_.set_parameters(network_, state_->parameter.data());
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (const int r : network_.integrated_in(voxels_->material[i])) {
      for (const int s : network_.reactions()[r].reads) {
        if (place_of_[s] < 0) continue;
        const std::size_t column = i * stride + place_of_[s];
        direction_[column] = 1.0;
        const double slope = y ? rate_along(laws_.of_reaction[r], r, i, y, direction_.data()) : 0.0;
        direction_[column] = 0.0;
        for (const Change& change : network_.reactions()[r].changes) {
          const auto d = std::size_t(place_of_[change.species]);
          const std::size_t book = unknowns() + (change.amount > 0 ? created : destroyed) * stride + d;
          const double taken = change.amount > 0 ? slope : -slope;
          entries.push_back({std::uint32_t(i * stride + d), std::uint32_t(column), change.amount * slope});
          entries.push_back({std::uint32_t(book), std::uint32_t(column), change.amount * taken});
        }
      }
    }
  }
  surface_entries(y, entries);
}

}  // namespace shmoo::rdme
