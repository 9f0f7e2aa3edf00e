#include "sph/clusters.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::sph {
namespace {

using base::Lane;
constexpr auto lanes = std::size_t(base::lanes);
constexpr std::size_t clusters_per_chunk = 64;  // fixed, so that nothing depends on the number of threads

}  // namespace

template <int D>
Clusters<D>::Clusters(std::span<const Vec> positions, const base::Box<D>& box, double cutoff)
    : box_(box), cutoff_(cutoff), built_at_(positions.begin(), positions.end()) {
  measure(positions);
  columns_.sort(grid_, anchor_);
  lay(columns_.order());
  add_images();
  const auto at = coordinates(positions);
  list_.resize(size());
  partners_.resize((size() + clusters_per_chunk - 1) / clusters_per_chunk);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t c = 0; c < partners_.size(); ++c) list_partners(c, at);
}

// The extent of all particles, and columns in which a cluster is about as wide as high.
template <int D>
void Clusters<D>::measure(std::span<const Vec> positions) {
  Vec lower = box_.lower, upper = box_.upper;
  for (const Vec& x : positions) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  origin_ = lower;
  const Vec extent = upper - lower;
  grain_ = 1.5 * 0x1p52 * std::ldexp(1.0, std::ilogb(extent.maxCoeff() + cutoff_) - 50);
  begin_ = snapped(box_.lower - origin_);
  end_ = snapped(box_.upper - origin_);
  for (const Vec& x : positions) anchor_.push_back(snapped(x - origin_));
  const double n = double(std::max<std::size_t>(positions.size(), 1)), most = 4.0 * n + 4096.0;
  for (double width = std::pow(double(lanes) * extent.prod() / n, 1.0 / D);; width *= 1.25) {
    grid_ = lay_columns<D>(Vec(Vec::Zero()), extent, width, box_.periodic, cutoff_);
    if (double(grid_.columns()) * grid_.layers() <= most) return;
  }
}

template <int D>
void Clusters<D>::lay(std::span<const std::uint32_t> order) {
  place_.resize(order.size());
  padding_.assign(grid_.columns(), 0);
  for (std::size_t c = 0; c < grid_.columns(); ++c) {
    const std::uint32_t begin = columns_.first(c), end = columns_.first(c + 1);
    padding_[c] = std::uint32_t(particle_.size()) - begin;
    for (std::uint32_t i = begin; i < end; i += lanes) {
      count_.push_back(std::min(end - i, std::uint32_t(lanes)));
      for (std::uint32_t l = 0; l < count_.back(); ++l) place_[order[i + l]] = std::uint32_t(particle_.size()) + l;
      for (std::uint32_t l = 0; l < lanes; ++l) particle_.push_back(order[std::min(i + l, end - 1)]);
    }
  }
}

// Of all that stands within the cutoff of a side, and of what is beyond other sides there.
template <int D>
void Clusters<D>::add_images() {
  std::vector<std::uint32_t> source;
  std::vector<Passage> passage;
  std::vector<Vec> points;
  for (int a = 0; a < D; ++a) {
    const double lower = begin_[a], upper = end_[a];
    const auto look = [&](std::uint32_t i, const Vec& x, Passage way) {
      for (const std::int8_t side : {1, 2}) {
        if ((side == 1 ? x[a] - lower : upper - x[a]) >= cutoff_) continue;
        way[std::size_t(a)] = side;
        source.push_back(i);
        passage.push_back(way);
        points.push_back(passed(anchor_[i], way));
      }
    };
    const std::size_t so_far = source.size();
    for (std::size_t k = 0; k < so_far; ++k) look(source[k], Vec(points[k]), Passage(passage[k]));
    for (std::size_t i = 0; i < anchor_.size(); ++i) look(std::uint32_t(i), anchor_[i], {});
  }
  image_columns_.sort(grid_, points);
  for (const std::uint32_t k : image_columns_.order()) {
    particle_.push_back(source[k]);
    passage_.push_back(passage[k]);
  }
}

template <int D>
typename Clusters<D>::Coordinates Clusters<D>::coordinates(std::span<const Vec> positions) const {
  Coordinates at;
  for (auto& axis : at) axis.resize(particle_.size() + lanes);
  const std::size_t own = lanes * size();
  for (std::size_t p = 0; p < own; ++p) {
    const std::size_t i = particle_[p];
    const Vec x = snapped(anchor_[i] + box_.nearest(positions[i] - built_at_[i]));
    for (int a = 0; a < D; ++a) at[std::size_t(a)][p] = x[a];
  }
  for (std::size_t p = own; p < particle_.size(); ++p) {
    const std::size_t source = place_[particle_[p]];
    Vec x;
    for (int a = 0; a < D; ++a) x[a] = at[std::size_t(a)][source];
    x = passed(x, passage_[p - own]);
    for (int a = 0; a < D; ++a) at[std::size_t(a)][p] = x[a];
  }
  return at;
}

template <int D>
void Clusters<D>::list_partners(std::size_t chunk, const Coordinates& at) {
  const std::size_t own = lanes * size();
  for (std::size_t c = chunk * clusters_per_chunk; c < std::min((chunk + 1) * clusters_per_chunk, size()); ++c) {
    List list{std::uint32_t(chunk), 0, 0};
    if (c > chunk * clusters_per_chunk) list.begin = list_[c - 1].begin + list_[c - 1].size;
    Vec lower = anchor_[particle_[lanes * c]], upper = lower;
    for (std::size_t l = 1; l < lanes; ++l) {
      lower = lower.cwiseMin(anchor_[particle_[lanes * c + l]]);
      upper = upper.cwiseMax(anchor_[particle_[lanes * c + l]]);
    }
    columns_.visit(lower, upper, cutoff_, [&](std::size_t column, std::uint32_t begin, std::uint32_t end) {
      append(chunk, list, at, lower, upper, begin + padding_[column], end + padding_[column]);
    });
    image_columns_.visit(lower, upper, cutoff_, [&](std::size_t, std::uint32_t begin, std::uint32_t end) {
      append(chunk, list, at, lower, upper, begin + own, end + own);
    });
    list_[c] = list;
  }
}

// Appends the places begin .. end - 1 that lie within the cutoff of the cluster's extent.
template <int D>
void Clusters<D>::append(std::size_t chunk, List& list, const Coordinates& at, const Vec& lower, const Vec& upper,
                         std::size_t begin, std::size_t end) {
  auto& partners = partners_[chunk];
  std::size_t size = list.begin + list.size;
  if (partners.size() < size + (end - begin) + lanes) partners.resize(2 * size + (end - begin) + 100 * lanes);
  for (std::size_t p = begin; p < end; p += lanes) {
    Lane gap2{};
    for (int a = 0; a < D; ++a) {
      const Lane x = base::load(at[std::size_t(a)].data() + p);
      const Lane gap = base::larger(base::larger(lower[a] - x, x - upper[a]), Lane{});
      gap2 += gap * gap;
    }
    const std::size_t most = std::min(end - p, lanes);
    for (std::size_t l = 0; l < most; ++l) {
      partners[size] = std::uint32_t(p + l);
      size += gap2[int(l)] < cutoff_ * cutoff_;
    }
  }
  list.size = std::uint32_t(size - list.begin);
}

template <int D>
typename Clusters<D>::Vec Clusters<D>::snapped(const Vec& x) const {
  Vec y;
  for (int a = 0; a < D; ++a) y[a] = (x[a] + grain_) - grain_;
  return y;
}

// Through the lower side a periodic image comes out beyond the upper one.
template <int D>
typename Clusters<D>::Vec Clusters<D>::passed(Vec x, const Passage& passage) const {
  for (int a = 0; a < D; ++a) {
    const int side = passage[std::size_t(a)];
    if (side == 0) continue;
    if (box_.periodic[std::size_t(a)])
      x[a] += side == 1 ? end_[a] - begin_[a] : begin_[a] - end_[a];
    else
      x[a] = 2.0 * (side == 1 ? begin_[a] : end_[a]) - x[a];
  }
  return x;
}

template class Clusters<1>;
template class Clusters<2>;
template class Clusters<3>;

}  // namespace shmoo::sph
