#include "hydro/pair_rows.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace shmoo::hydro {
namespace {

constexpr std::size_t rows_per_chunk = 256;  // fixed, so that nothing depends on the number of threads

// What was there is not wanted any more: it goes before more room is taken, so that both are never held.
template <class Value>
void make_room(std::vector<Value>& values, std::size_t size) {
  values.clear();
  if (values.capacity() < size) {
    std::vector<Value>().swap(values);
    values.reserve(size + size / 16);
  }
  values.resize(size);
}

}  // namespace

template <int D>
PairRows<D>::PairRows(const base::Box<D>& box, double reach, double skin, double spacing,
                      const typename Blocks<D>::Mirrors& mirrors)
    : blocks(box, reach + skin, spacing, mirrors), box_(box), reach_(reach), skin_(skin) {
  for (int a = 0; a < D; ++a) {
    axes_[a].length = box.upper[a] - box.lower[a];
    axes_[a].half = box.periodic[a] ? 0.5 * axes_[a].length : std::numeric_limits<double>::infinity();
  }
}

template <int D>
void PairRows<D>::build(sph::Particles<D>& particles, const std::vector<double>* smoothing) {
  if (smoothing) {
    const OwnReach own{*smoothing, 0.5 * reach_};
    blocks.build(particles, &own);
  } else {
    blocks.build(particles);
  }
  fluid_.resize(blocks.fluid());
  std::iota(fluid_.begin(), fluid_.end(), 0U);
  list_rows(particles, smoothing);
  ++builds_;
}

template <int D>
bool PairRows<D>::follow(const sph::Particles<D>& particles) {
  return blocks.follow(particles.position.values()) < 0.25 * skin_ * skin_;
}

// The particles of blocks that have solids about, and those solids: deep in a wall there is nothing to list.
template <int D>
std::vector<std::uint32_t> PairRows<D>::rows_wanted(std::size_t particles) const {
  std::vector<std::uint32_t> wanted;
  std::vector<char> met(particles, 0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    if (!block.at_wall) continue;
    for (std::uint32_t l = 0; l < block.size; ++l) wanted.push_back(block.first + l);
    const std::int32_t* partners = blocks.partners(block);
    for (std::uint32_t k = 0; k < block.partners; ++k) met[blocks.particle(std::size_t(partners[k]))] = 1;
  }
  for (std::size_t i = blocks.fluid(); i < particles; ++i)
    if (met[i]) wanted.push_back(std::uint32_t(i));
  return wanted;
}

template <int D>
void PairRows<D>::list_rows(const sph::Particles<D>& particles, const std::vector<double>* smoothing) {
  const std::size_t n = particles.size();
  const auto wanted = rows_wanted(n);
  first_.assign(n + 1, 0);
  chunks_.resize((wanted.size() + rows_per_chunk - 1) / rows_per_chunk);
#pragma omp parallel for schedule(dynamic) if (worth_threads(4 * wanted.size()))
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    auto& row = chunks_[c].partner;
    row.clear();
    for (std::size_t k = c * rows_per_chunk; k < std::min((c + 1) * rows_per_chunk, wanted.size()); ++k) {
      const std::size_t before = row.size();
      list_row(particles, smoothing, wanted[k], row);
      first_[wanted[k] + 1] = row.size() - before;
    }
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  make_room(partner_, first_[n]);
  make_room(weight, first_[n]);
  auto next = partner_.begin();
  for (const Chunk& chunk : chunks_) next = std::copy(chunk.partner.begin(), chunk.partner.end(), next);
  solid_.clear();
  near_wall_.clear();
  for (const std::uint32_t i : wanted) {
    if (count(i) > 0) (i < blocks.fluid() ? near_wall_ : solid_).push_back(i);
  }
}

// Appends the partners of particle i, if i is solid or any of them is.
template <int D>
void PairRows<D>::list_row(const sph::Particles<D>& particles, const std::vector<double>* smoothing, std::size_t i,
                           std::vector<std::int32_t>& row) const {
  const auto& x = particles.position.values();
  const auto limit = [&](std::size_t j) {
    const double within = smoothing ? (*smoothing)[i] + (*smoothing)[j] + skin_ : cutoff();
    return within * within;
  };
  const bool flows = i < blocks.fluid();
  const std::size_t before = row.size();
  bool met_solid = !flows;
  blocks.visit_around(i, !flows, [&](std::size_t j) {
    if (j == i || (!flows && j >= blocks.fluid())) return;
    if (!(box_.nearest(x[i] - x[j]).squaredNorm() < limit(j))) return;
    row.push_back(std::int32_t(j));
    met_solid = met_solid || j >= blocks.fluid();
  });
  if (!met_solid) row.resize(before);
  std::sort(row.begin() + std::ptrdiff_t(before), row.end());
  row.erase(std::unique(row.begin() + std::ptrdiff_t(before), row.end()), row.end());
}

template <int D>
std::size_t PairRows<D>::bytes() const {
  return blocks.bytes() + partner_.size() * (sizeof(std::int32_t) + sizeof(double));
}

template class PairRows<2>;
template class PairRows<3>;

}  // namespace shmoo::hydro
