#include "rdme/lump.hpp"

#include <cmath>
#include <map>
#include <numeric>

namespace shmoo::rdme {
namespace {

using Point = std::array<double, 3>;

struct Extent {
  Point lower{};
  double widest = 0;  // [m]
};

Extent extent(const Voxels& voxels) {
  Extent extent{voxels.position.front()};
  Point upper = voxels.position.front();
  for (const Point& x : voxels.position)
    for (std::size_t a = 0; a < 3; ++a) {
      extent.lower[a] = std::min(extent.lower[a], x[a]);
      upper[a] = std::max(upper[a], x[a]);
    }
  for (std::size_t a = 0; a < 3; ++a) extent.widest = std::max(extent.widest, upper[a] - extent.lower[a]);
  return extent;
}

std::size_t group(const Voxels& voxels, const Extent& extent, double edge, std::vector<std::uint32_t>& of) {
  std::map<std::array<long, 4>, std::uint32_t> cubes;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    std::array<long, 4> cube{voxels.material[i]};
    for (std::size_t a = 0; a < 3; ++a) cube[a + 1] = long((voxels.position[i][a] - extent.lower[a]) / edge);
    of[i] = cubes.try_emplace(cube, std::uint32_t(cubes.size())).first->second;
  }
  return cubes.size();
}

std::vector<std::uint32_t> group(const Voxels& voxels, std::size_t most) {
  std::vector<std::uint32_t> of(voxels.size());
  std::iota(of.begin(), of.end(), 0u);
  if (voxels.size() <= most) return of;
  constexpr double finest = 64, growth = 1.25;
  const auto space = extent(voxels);
  double edge = space.widest / finest;
  while (group(voxels, space, edge, of) > most && edge <= space.widest) edge *= growth;
  return of;
}

class Lumping {
 public:
  Lumping(const Voxels& fine, std::vector<std::uint32_t> of, const Point& period)
      : fine_(fine), of_(std::move(of)), period_(period), count_(*std::ranges::max_element(of_) + 1u) {}

  Voxels make() const {
    Voxels coarse;
    add_places(coarse);
    for (const auto& graph : fine_.graphs) coarse.graphs.push_back(graph_of(graph, coarse));
    coarse.graph_of_species = fine_.graph_of_species;
    add_exchanges(coarse);
    for (const auto& surface : fine_.surfaces) coarse.surfaces.push_back(surface_of(surface));
    return coarse;
  }

  const std::vector<std::uint32_t>& of() const { return of_; }

 private:
  double distance(const Point& x, const Point& y) const {
    double r2 = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      double d = std::abs(x[a] - y[a]);
      if (period_[a] > 0.0) d = std::min(d, std::abs(period_[a] - d));
      r2 += d * d;
    }
    return std::sqrt(r2);
  }

  void add_places(Voxels& coarse) const {
    coarse.volume.assign(count_, 0.0);
    coarse.material.assign(count_, 0);
    coarse.position.assign(count_, Point{});
    for (std::size_t i = 0; i < fine_.size(); ++i) {
      coarse.volume[of_[i]] += fine_.volume[i];
      coarse.material[of_[i]] = fine_.material[i];
      for (std::size_t a = 0; a < 3; ++a) coarse.position[of_[i]][a] += fine_.volume[i] * fine_.position[i][a];
    }
    for (std::size_t g = 0; g < count_; ++g)
      for (double& x : coarse.position[g]) x /= coarse.volume[g];
  }

  struct Link {
    double conductance = 0, flow = 0;
  };
  using Links = std::vector<std::map<std::uint32_t, Link>>;  // by voxel, ascending by target

  JumpGraph graph_of(const JumpGraph& graph, const Voxels& coarse) const {
    Links links(count_);
    for (std::size_t i = 0; i < fine_.size(); ++i)
      for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p) {
        const auto j = graph.target[p];
        if (of_[i] == of_[j]) continue;
        Link& link = links[of_[i]][of_[j]];
        link.conductance += fine_.volume[i] * graph.coupling[p] * distance(fine_.position[i], fine_.position[j]);
        if (!graph.flow.empty()) link.flow += graph.flow[p];
      }
    JumpGraph result;
    result.first.push_back(0);
    for (std::size_t g = 0; g < count_; ++g) {
      for (const auto& [h, link] : links[g]) {
        result.target.push_back(h);
        const double length = distance(coarse.position[g], coarse.position[h]);
        result.coupling.push_back(length > 0.0 ? link.conductance / (length * coarse.volume[g]) : 0.0);
        if (!graph.flow.empty()) result.flow.push_back(link.flow);
      }
      result.first.push_back(result.target.size());
    }
    return result;
  }

  void add_exchanges(Voxels& coarse) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Exchange> all;
    for (const auto& one : fine_.exchanges) {
      const auto g = of_[one.voxel];
      Exchange& sum = all.try_emplace({g, one.species}, Exchange{g, one.species}).first->second;
      sum.exit_rate += one.exit_rate * fine_.volume[one.voxel] / coarse.volume[g];
      sum.entry_rate += one.entry_rate;
    }
    for (const auto& [place, exchange] : all) coarse.exchanges.push_back(exchange);
  }

  Surface surface_of(const Surface& surface) const {
    std::vector<std::map<std::uint32_t, double>> areas(count_);
    for (std::size_t i = 0; i < fine_.size(); ++i)
      for (auto p = surface.first[i]; p < surface.first[i + 1]; ++p)
        areas[of_[i]][of_[surface.target[p]]] += surface.area[p];
    Surface result{surface.materials, {0}, {}, {}, {}};
    for (const auto& row : areas) {
      double sum = 0.0;
      for (const auto& [h, area] : row) sum += area;
      for (const auto& [h, area] : row) {
        result.target.push_back(h);
        result.area.push_back(area);
        result.share.push_back(area / sum);
      }
      result.first.push_back(result.target.size());
    }
    return result;
  }

  const Voxels& fine_;
  std::vector<std::uint32_t> of_;
  Point period_;
  std::size_t count_;
};

}  // namespace

Lumps lump(const Voxels& voxels, std::size_t most, const Point& period) {
  const Lumping lumping(voxels, group(voxels, most), period);
  return {lumping.make(), lumping.of()};
}

}  // namespace shmoo::rdme
