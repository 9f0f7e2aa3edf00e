#include "hydro/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace shmoo::hydro {
namespace {

constexpr std::size_t blocks_per_chunk = 64;  // fixed, so that nothing depends on the number of threads

// How far partners are listed [m]: of a block, and, of that, the squares for eight slots.
struct OneCutoff {
  double cutoff;
  struct Within {
    double limit;
    Lane squared(std::size_t) const { return same(limit); }
  };
  double farthest(const Block&) const { return cutoff; }
  Within within(const Block&) const { return {cutoff * cutoff}; }
};

struct OwnCutoffs {
  double cutoff;
  const OwnReach& own;
  const double* smoothing;  // of slots
  struct Within {
    double from;
    const double* smoothing;
    Lane squared(std::size_t slot) const {
      const Lane distance = from + load(smoothing + slot);
      return distance * distance;
    }
  };
  double largest_in(const Block& block) const {
    const auto first = own.smoothing.begin() + block.first;
    return *std::max_element(first, first + block.size);
  }
  double farthest(const Block& block) const { return cutoff - own.largest + largest_in(block); }
  Within within(const Block& block) const { return {farthest(block) - own.largest, smoothing}; }
};

}  // namespace

template <int D>
void Blocks<D>::build(sph::Particles<D>& particles, const OwnReach* own) {
  measure(particles.position.values());
  sort(particles);
  lay_blocks();
  add_others();
  place_slots();
  smoothing.resize(own ? particle_.size() + lanes : 0);
  if (own) for_slots([&](std::size_t s, std::size_t i) { smoothing[s] = own->smoothing[i]; });
  chunks_.resize((blocks_.size() + blocks_per_chunk - 1) / blocks_per_chunk);
#pragma omp parallel for schedule(dynamic) if (worth_threads(fluid_))
  for (std::size_t c = 0; c < chunks_.size(); ++c)
    own ? list_partners(c, OwnCutoffs{cutoff_, *own, smoothing.data()}) : list_partners(c, OneCutoff{cutoff_});
}

// The extent of all particles, and columns in which a block of eight is about as wide as high.
template <int D>
void Blocks<D>::measure(const std::vector<Vec>& position) {
  Vec lower = box_.lower, upper = box_.upper;
  for (const Vec& x : position) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  for (int a = 0; a < D; ++a) {
    if (!box_.periodic[a]) continue;
    lower[a] = box_.lower[a];
    upper[a] = box_.upper[a];
  }
  origin_ = lower;
  const Vec extent = upper - lower;
  grain_ = 1.5 * 0x1p52 * std::ldexp(1.0, std::ilogb(extent.maxCoeff() + cutoff_) - 50);
  for (int a = 0; a < D; ++a) length_[a] = box_.periodic[a] ? snap(extent[a]) : 0.0;
  double width = spacing_ * std::pow(double(lanes), 1.0 / D);
  const double most = 4.0 * double(position.size()) + 4096.0;
  for (;; width *= 1.25) {
    grid_ = sph::lay_columns<D>(Vec(Vec::Zero()), extent, width, box_.periodic, cutoff_);
    if (double(grid_.columns()) * grid_.layers() <= most) return;
  }
}

template <int D>
void Blocks<D>::sort(sph::Particles<D>& particles) {
  const std::size_t n = particles.size();
  std::vector<std::uint32_t> order;
  std::vector<Vec> points;
  order.reserve(n);
  points.reserve(n);
  const auto take = [&](bool flowing) {
    const std::size_t before = order.size();
    for (std::size_t i = 0; i < n; ++i) {
      if ((particles.role[i] == sph::Role::fluid) != flowing) continue;
      order.push_back(std::uint32_t(i));
      points.push_back(particles.position[i] - origin_);
    }
    auto& columns = flowing ? fluid_columns_ : other_columns_;
    columns.sort(grid_, std::span<const Vec>(points).subspan(before));
    std::vector<std::uint32_t> sorted(order.size() - before);
    for (std::size_t k = 0; k < sorted.size(); ++k) sorted[k] = order[before + columns.order()[k]];
    std::copy(sorted.begin(), sorted.end(), order.begin() + std::ptrdiff_t(before));
  };
  take(true);
  fluid_ = order.size();
  take(false);
  solids_ = n - fluid_;
  particles.permute(order);
  built_at_ = particles.position.values();
  anchor_.resize(n);
  for (std::size_t i = 0; i < n; ++i) anchor_[i] = snapped(built_at_[i] - origin_);
  now_ = anchor_;
}

template <int D>
void Blocks<D>::lay_blocks() {
  blocks_.clear();
  particle_.clear();
  slot_.clear();
  padding_.assign(grid_.columns(), 0);
  for (std::size_t c = 0; c < grid_.columns(); ++c) {
    const std::uint32_t begin = fluid_columns_.first(c), end = fluid_columns_.first(c + 1);
    padding_[c] = std::uint32_t(particle_.size()) - begin;
    for (std::uint32_t i = begin; i < end; i += lanes) {
      blocks_.push_back({.first = i, .size = std::min(end - i, std::uint32_t(lanes))});
      for (std::uint32_t l = 0; l < blocks_.back().size; ++l) slot_.push_back(std::uint32_t(particle_.size()) + l);
      for (std::uint32_t l = 0; l < lanes; ++l) particle_.push_back(std::min(i + l, end - 1));
    }
  }
}

template <int D>
bool Blocks<D>::any_mirror() const {
  return std::any_of(mirrors_.begin(), mirrors_.end(), [](const auto& axis) { return axis[0] || axis[1]; });
}

// Adds the images across the sides of an axis of the fluid and of all images so far.
template <int D>
void Blocks<D>::add_images(Images& images, int axis) const {
  const auto add = [&](std::uint32_t i, Vec point, Vec shift, double by, std::uint8_t turned) {
    const bool turns = turned != 0;
    point[axis] = (turns ? -point[axis] : point[axis]) + by;
    shift[axis] = by;
    images.source.push_back(i);
    images.shift.push_back(shift);
    images.point.push_back(point);
  };
  const auto reflect = [&](std::uint32_t i, const Vec& x, const Vec& shift, std::uint8_t turned, int side) {
    const double at = plane(axis, side);
    if (!(std::abs(x[axis] - at) < cutoff_)) return;
    add(i, x, shift, 2.0 * at, 1);
    images.turned.push_back(std::uint8_t(turned | (1U << axis)));
  };
  const auto image = [&](std::uint32_t i, const Vec& x, const Vec& shift, std::uint8_t turned) {
    for (int side = 0; side < 2; ++side)
      if (mirrors_[std::size_t(axis)][std::size_t(side)]) reflect(i, x, shift, turned, side);
    const bool low = x[axis] < cutoff_;
    if (!box_.periodic[std::size_t(axis)] || (!low && x[axis] < length_[axis] - cutoff_)) return;
    add(i, x, shift, low ? length_[axis] : -length_[axis], 0);
    if (any_mirror()) images.turned.push_back(turned);
  };
  const std::size_t so_far = images.source.size();
  for (std::size_t k = 0; k < so_far; ++k)
    image(images.source[k], Vec(images.point[k]), Vec(images.shift[k]), images.turned.empty() ? 0 : images.turned[k]);
  for (std::size_t i = 0; i < fluid_; ++i) image(std::uint32_t(i), anchor_[i], Vec::Zero(), 0);
}

// Solids, and images of all that stands within the cutoff of a periodic side or a mirror.
template <int D>
void Blocks<D>::add_others() {
  Images images;
  images.source.resize(solids_);
  std::iota(images.source.begin(), images.source.end(), std::uint32_t(fluid_));
  images.shift.assign(solids_, Vec(Vec::Zero()));
  images.point.assign(anchor_.begin() + std::ptrdiff_t(fluid_), anchor_.end());
  if (any_mirror()) images.turned.assign(solids_, 0);
  for (int a = 0; a < D; ++a)
    if (box_.periodic[a] || mirrors_[a][0] || mirrors_[a][1]) add_images(images, a);
  fluid_images_ = std::any_of(images.source.begin() + std::ptrdiff_t(solids_), images.source.end(),
                              [&](std::uint32_t source) { return source < fluid_; });
  other_columns_.sort(grid_, images.point);
  const auto order = other_columns_.order();
  shift_.resize(order.size());
  turned_.resize(images.turned.size());
  particle_.resize(block_slots() + order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    shift_[k] = images.shift[order[k]];
    particle_[block_slots() + k] = images.source[order[k]];
    if (!turned_.empty()) turned_[k] = images.turned[order[k]];
  }
  for (auto& axis : coordinate) axis.resize(particle_.size() + lanes);
}

template <int D>
void Blocks<D>::place_slots() {
  const std::size_t others = block_slots();
  for_slots([&](std::size_t s, std::size_t i) {
    for (int a = 0; a < D; ++a) {
      const double own = mirrored(s, a) ? -now_[i][a] : now_[i][a];
      coordinate[std::size_t(a)][s] = own + (s < others ? 0.0 : shift_[s - others][a]);
    }
  });
}

template <int D>
double Blocks<D>::follow(const std::vector<Vec>& position) {
  double farthest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : farthest) if (worth_threads(position.size() / 4))
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vec way = box_.nearest(position[i] - built_at_[i]);
    const double way2 = way.squaredNorm();
    farthest = way2 >= 0.0 ? std::max(farthest, way2) : std::numeric_limits<double>::infinity();
    now_[i] = snapped(anchor_[i] + way);
  }
  place_slots();
  return farthest;
}

template <int D>
template <class Cutoff>
void Blocks<D>::list_partners(std::size_t c, const Cutoff& cutoff) {
  Chunk& chunk = chunks_[c];
  std::size_t size = 0;
  for (std::size_t b = c * blocks_per_chunk; b < std::min((c + 1) * blocks_per_chunk, blocks_.size()); ++b) {
    Block& block = blocks_[b];
    block.chunk = std::uint32_t(c);
    block.begin = std::uint32_t(size);
    block.partners = 0;
    Vec lower = anchor_[block.first], upper = lower;
    for (std::uint32_t i = block.first; i < block.first + block.size; ++i) {
      lower = lower.cwiseMin(anchor_[i]);
      upper = upper.cwiseMax(anchor_[i]);
    }
    const double farthest = cutoff.farthest(block);
    const auto within = cutoff.within(block);
    fluid_columns_.visit(lower, upper, farthest, [&](std::size_t column, std::uint32_t begin, std::uint32_t end) {
      append(chunk, block, lower, upper, begin + padding_[column], end + padding_[column], within);
    });
    other_columns_.visit(lower, upper, farthest, [&](std::size_t, std::uint32_t begin, std::uint32_t end) {
      append(chunk, block, lower, upper, begin + block_slots(), end + block_slots(), within);
    });
    size += block.partners;
    const std::int32_t* list = chunk.partners.data() + block.begin;
    block.at_wall = solids_ > 0 && std::any_of(list, list + block.partners, [&](std::int32_t slot) {
                      return particle_[std::size_t(slot)] >= fluid_;
                    });
  }
  chunk.near.resize(chunk.partners.size());
}

// Appends the slots begin .. end - 1 that lie within the cutoff of the block's extent.
template <int D>
template <class Within>
void Blocks<D>::append(Chunk& chunk, Block& block, const Vec& lower, const Vec& upper, std::size_t begin,
                       std::size_t end, const Within& within) {
  std::size_t size = block.begin + block.partners;
  if (chunk.partners.size() < size + (end - begin) + lanes)
    chunk.partners.resize(2 * size + (end - begin) + 100 * lanes);
  std::int32_t* list = chunk.partners.data();
  for (std::size_t s = begin; s < end; s += lanes) {
    const Lane limit = within.squared(s);
    Lane gap2{};
    for (int a = 0; a < D; ++a) {
      const Lane x = load(coordinate[std::size_t(a)].data() + s);
      const Lane gap = larger(larger(lower[a] - x, x - upper[a]), Lane{});
      gap2 += gap * gap;
    }
    const std::size_t most = std::min<std::size_t>(end - s, lanes);
    for (std::size_t l = 0; l < most; ++l) {
      list[size] = std::int32_t(s + l);
      size += gap2[l] < limit[l];
    }
  }
  block.partners = std::uint32_t(size - block.begin);
}

template <int D>
std::uint64_t Blocks<D>::partners() const {
  std::uint64_t sum = 0;
  for (const Block& block : blocks_) sum += block.partners;
  return sum;
}

template <int D>
std::size_t Blocks<D>::bytes() const {
  std::size_t sum = blocks_.size() * sizeof(Block) + 3 * anchor_.size() * sizeof(Vec) + shift_.size() * sizeof(Vec);
  sum += particle_.size() * (sizeof(std::uint32_t) + D * sizeof(double));
  for (const Chunk& chunk : chunks_) sum += 2 * chunk.partners.size() * sizeof(std::int32_t);
  return sum;
}

template class Blocks<2>;
template class Blocks<3>;

}  // namespace shmoo::hydro
