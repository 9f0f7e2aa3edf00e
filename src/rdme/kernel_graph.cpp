#include "rdme/kernel_graph.hpp"

#include <limits>

#include "base/lanes.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::size_t chunk = 256;  // voxels
constexpr std::size_t lanes = base::lanes;  // pairs are weighed and summed so many at a time

using base::Lane;

template <int D>
class KernelGraph {
 public:
  explicit KernelGraph(const Surroundings<D>& around) : around_(around), scale_(around.size()) {
    const auto& places = around.places;
    for (auto& x : position_) x.resize(around.size());
    for (std::size_t i = 0; i < around.size(); ++i) {
      for (int a = 0; a < D; ++a) position_[std::size_t(a)][i] = places.position[i][a];
      const bool inside = around.is_home(i) || around.is_clamped(i);
      inside_.push_back(inside);
      home_.push_back(around.is_home(i));
      moment_.push_back((inside ? 1.0 : 0.5) * places.area[i] / D);
    }
    for (int a = 0; a < D; ++a) {
      length_[std::size_t(a)] = around.box.upper[a] - around.box.lower[a];
      half_[std::size_t(a)] =
          around.box.periodic[std::size_t(a)] ? 0.5 * length_[std::size_t(a)] : std::numeric_limits<double>::infinity();
    }
  }

  JumpGraph make() {
    const std::size_t n = around_.size();
    graph_.first.assign(n + 1, 0);
    std::visit(
        [&](const auto& kernel) {
#pragma omp parallel for schedule(dynamic, 256)
          for (std::size_t i = 0; i < n; ++i) measure(kernel, i);
          for (std::size_t i = 0; i < n; ++i) graph_.first[i + 1] += graph_.first[i];
          graph_.target.resize(graph_.first[n]);
          graph_.coupling.resize(graph_.first[n]);
          if (!around_.places.drift.empty()) graph_.flow.resize(graph_.first[n]);
#pragma omp parallel for schedule(dynamic)
          for (std::size_t begin = 0; begin < n; begin += chunk) {
            Row row;
            for (std::size_t i = begin; i < std::min(n, begin + chunk); ++i) fill(kernel, i, row);
          }
        },
        around_.kernel);
    return std::move(graph_);
  }

 private:
  struct Row {
    std::vector<std::uint32_t> target;
    std::vector<double> coupling;
  };
  struct Lanes {
    std::uint32_t j[lanes];
    Lane r2, F;
  };

  static Lane gather(const double* values, const std::uint32_t (&j)[lanes]) {
    return Lane{values[j[0]], values[j[1]], values[j[2]], values[j[3]],
                values[j[4]], values[j[5]], values[j[6]], values[j[7]]};
  }

  // Calls visit(eight of its pairs) along the row of i; the last eight are filled up with i itself.
  template <class Kernel, class Visit>
  void each_lanes(const Kernel& any_kernel, std::size_t i, Visit visit) const {
    const Kernel kernel = any_kernel;
    const auto row = around_.rows.row(i);
    Lanes some;
    for (std::size_t k = 0; k < row.size(); k += lanes) {
      for (std::size_t l = 0; l < lanes; ++l) some.j[l] = k + l < row.size() ? row[k + l] : std::uint32_t(i);
      some.r2 = Lane{};
      for (std::size_t a = 0; a < D; ++a) {
        Lane d = position_[a][i] - gather(position_[a].data(), some.j);
        d = d > half_[a] ? d - length_[a] : d;
        d = d < -half_[a] ? d + length_[a] : d;
        some.r2 += d * d;
      }
      double r2[lanes], F[lanes];
      base::store(some.r2, r2);
#pragma omp simd
      for (std::size_t l = 0; l < lanes; ++l) F[l] = kernel.F(std::sqrt(r2[l]));
      some.F = base::load(F);
      visit(some);
    }
  }

  // The second moment around i, and how many jumps its row will hold.
  template <class Kernel>
  void measure(const Kernel& kernel, std::size_t i) {
    if (!inside_[i]) return;
    Lane part{};
    std::uint32_t jumps = 0;
    each_lanes(kernel, i, [&](const Lanes& some) {
      part += gather(moment_.data(), some.j) * some.F * some.r2;
      for (std::size_t l = 0; l < lanes; ++l) jumps += (some.F[l] > 0.0) & inside_[some.j[l]] & (some.j[l] != i);
    });
    double moment = ((part[0] + part[4]) + (part[1] + part[5])) + ((part[2] + part[6]) + (part[3] + part[7]));
    if (around_.near_side(i)) moment += moment_of_images(kernel, i);
    scale_[i] = moment > 0.0 ? 1.0 / moment : 0.0;
    if (home_[i]) graph_.first[i + 1] = jumps;
  }

  template <class Kernel>
  double moment_of_images(const Kernel& kernel, std::size_t i) const {
    double moment = 0.0;
    const auto add = [&](std::size_t j) {
      around_.each_image(i, j, [&](unsigned, const base::Vec<D>& x_ij) {
        const double r2 = x_ij.squaredNorm();
        moment += moment_[j] * kernel.F(std::sqrt(r2)) * r2;
      });
    };
    for (const std::uint32_t j : around_.rows.row(i)) add(j);
    add(i);
    return moment;
  }

  bool through_open(unsigned crossed) const {
    for (int side = 0; side < 2 * D; ++side)
      if ((crossed >> side & 1u) && around_.is_open(side)) return true;
    return false;
  }

  template <class Kernel>
  void fill(const Kernel& kernel, std::size_t i, Row& row) {
    if (!home_[i]) return;
    row.target.resize(around_.rows.row(i).size() + lanes);
    row.coupling.resize(row.target.size());
    std::size_t size = 0;
    each_lanes(kernel, i, [&](const Lanes& some) {
      const Lane coupling = (scale_[i] + gather(scale_.data(), some.j)) * gather(area_, some.j) * some.F;
      for (std::size_t l = 0; l < lanes; ++l) {  // what is no jump is overwritten by the next
        row.target[size] = some.j[l];
        row.coupling[size] = coupling[l];
        size += (some.F[l] > 0.0) & inside_[some.j[l]] & (some.j[l] != i);
      }
    });
    const auto at = std::ptrdiff_t(graph_.first[i]);
    std::copy_n(row.target.begin(), size, graph_.target.begin() + at);
    std::copy_n(row.coupling.begin(), size, graph_.coupling.begin() + at);
    if (!graph_.flow.empty()) add_flow(i);
    if (around_.near_side(i))
      for (std::uint64_t p = graph_.first[i]; p < graph_.first[i + 1]; ++p) add_images(kernel, i, p);
  }

  void add_flow(std::size_t i) {
    for (std::uint64_t p = graph_.first[i]; p < graph_.first[i + 1]; ++p) {
      const std::size_t j = graph_.target[p];
      graph_.flow[p] = around_.flow(i, j, 0u, around_.separation(i, j), graph_.coupling[p]);
    }
  }

  // A jump to an image leads to its particle.
  template <class Kernel>
  void add_images(const Kernel& kernel, std::size_t i, std::uint64_t at) {
    const std::size_t j = graph_.target[at];
    const double per_weight = (scale_[i] + scale_[j]) * area_[j];
    around_.each_image(i, j, [&](unsigned crossed, const base::Vec<D>& x_ij) {
      const double coupling = per_weight * kernel.F(x_ij.norm());
      if (!(coupling > 0.0) || through_open(crossed)) return;
      graph_.coupling[at] += coupling;
      if (!graph_.flow.empty()) graph_.flow[at] += around_.flow(i, j, crossed, x_ij, coupling);
    });
  }

  const Surroundings<D>& around_;
  std::array<std::vector<double>, D> position_;  // [m]
  std::array<double, D> length_{}, half_{};      // [m] of the box; half is infinite where it is not periodic
  const double* area_ = around_.places.area.data();
  std::vector<std::uint8_t> inside_, home_;
  std::vector<double> moment_;  // [m^D] weight of V_j in the second moment over D
  std::vector<double> scale_;   // s_i
  JumpGraph graph_;
};

}  // namespace

template <int D>
JumpGraph kernel_graph(const Surroundings<D>& around) {
  return KernelGraph<D>(around).make();
}

template JumpGraph kernel_graph(const Surroundings<1>&);
template JumpGraph kernel_graph(const Surroundings<2>&);
template JumpGraph kernel_graph(const Surroundings<3>&);

}  // namespace shmoo::rdme
