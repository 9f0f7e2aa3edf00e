#include "hydro/pair_rows.hpp"

#include <algorithm>
#include <limits>

namespace shmoo::hydro {
namespace {

constexpr std::size_t chunk_size = 512;  // particles; fixed, so that nothing depends on the number of threads

}  // namespace

template <int D>
PairRows<D>::PairRows(const base::Box<D>& box, double reach, double skin) : box_(box), reach_(reach), skin_(skin) {
  for (int a = 0; a < D; ++a) {
    axes_[a].length = box.upper[a] - box.lower[a];
    axes_[a].half = box.periodic[a] ? 0.5 * axes_[a].length : std::numeric_limits<double>::infinity();
  }
}

template <int D>
void PairRows<D>::build(sph::Particles<D>& particles) {
  const std::size_t n = particles.size();
  cells_.build(particles.position.values(), box_, cutoff());
  particles.permute(cells_.order());
  const std::size_t chunks = (n + chunk_size - 1) / chunk_size;
  chunks_.resize(chunks);
  count_.resize(n);
  first_.resize(n + 1);
#pragma omp parallel for schedule(dynamic) if (worth_threads(n))
  for (std::size_t c = 0; c < chunks; ++c) list_chunk(particles, c);
  first_[0] = 0;
  for (std::size_t i = 0; i < n; ++i) first_[i + 1] = first_[i] + (count_[i] + lanes - 1) / lanes * lanes;
  partner_.resize(first_[n]);
  weight.resize(first_[n]);
#pragma omp parallel for schedule(static) if (worth_threads(n))
  for (std::size_t c = 0; c < chunks; ++c) {
    std::copy(chunks_[c].partner.begin(), chunks_[c].partner.end(),
              partner_.begin() + std::ptrdiff_t(first_[c * chunk_size]));
  }
  built_at_ = particles.position.values();
  classify(particles);
  ++builds_;
}

template <int D>
void PairRows<D>::list_chunk(const sph::Particles<D>& particles, std::size_t chunk) {
  const auto& x = particles.position.values();
  const auto& role = particles.role.values();
  const double limit = cutoff() * cutoff();
  auto& out = chunks_[chunk].partner;
  out.clear();
  std::array<std::size_t, 27> around;
  const std::size_t end = std::min((chunk + 1) * chunk_size, x.size());
  for (std::size_t i = chunk * chunk_size; i < end; ++i) {
    const std::size_t begin = out.size();
    const bool flows = role[i] == sph::Role::fluid;
    const std::size_t cells = cells_.around(cells_.cell_of(x[i]), around);
    for (std::size_t c = 0; c < cells; ++c) {
      const auto members = cells_.members(around[c]);
      // Sorted: the members of a cell are now consecutive particles.
      const auto start = std::size_t(members.data() - cells_.order().data());
      std::size_t next = out.size();
      out.resize(next + members.size());
      for (std::size_t j = start; j < start + members.size(); ++j) {
        double r2 = 0.0;
        for (int a = 0; a < D; ++a) {
          const double d = axes_[a].nearest(x[i][a] - x[j][a]);
          r2 += d * d;
        }
        out[next] = static_cast<std::int32_t>(j);
        next += (r2 < limit) & (j != i) & (flows | (role[j] == sph::Role::fluid));
      }
      out.resize(next);
    }
    count_[i] = static_cast<std::uint32_t>(out.size() - begin);
    while ((out.size() - begin) % lanes != 0) out.push_back(static_cast<std::int32_t>(i));
  }
}

template <int D>
void PairRows<D>::classify(const sph::Particles<D>& particles) {
  fluid_.clear();
  solid_.clear();
  near_wall_.clear();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    if (particles.role[i] != sph::Role::fluid) {
      if (count_[i] > 0) solid_.push_back(index);
      continue;
    }
    fluid_.push_back(index);
    const auto is_solid = [&](std::int32_t j) { return particles.role[std::size_t(j)] != sph::Role::fluid; };
    const auto* row = partner_.data() + first_[i];
    if (std::any_of(row, row + count_[i], is_solid)) near_wall_.push_back(index);
  }
}

template <int D>
bool PairRows<D>::outdated(const std::vector<Vec>& position) const {
  const double limit = 0.25 * skin_ * skin_;
  bool moved = false;
#pragma omp parallel for schedule(static) reduction(|| : moved) if (worth_threads(position.size() / 4))
  for (std::size_t i = 0; i < position.size(); ++i) {
    moved = moved || !(box_.nearest(position[i] - built_at_[i]).squaredNorm() < limit);
  }
  return moved;
}

template <int D>
std::uint64_t PairRows<D>::pairs() const {
  std::uint64_t sum = 0;
  for (const std::uint32_t count : count_) sum += count;
  return sum;
}

template class PairRows<2>;
template class PairRows<3>;

}  // namespace shmoo::hydro
