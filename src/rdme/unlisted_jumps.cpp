#include "rdme/unlisted_jumps.hpp"

#include <algorithm>

#pragma GCC diagnostic ignored "-Wuninitialized"  // GCC 12 warns of its own _mm512_max_pd, which kernels use

namespace shmoo::rdme {
namespace {

using base::Lane, base::load;
constexpr auto lanes = std::size_t(base::lanes);
constexpr double tiny = 1e-300;  // [m^2] added to r^2, so that a particle can meet itself

constexpr double much_alike = 2;  // largest ratio of scalings nearby that is made up for by jumps that fail

// What is read of a place, together in memory.
template <int D>
struct Place {
  double x[D];          // [m]
  double area = 0;      // [m^D] V_j, 0 where the species does not live
  double scale = 0;     // [m^D] s_j
  double moment = 0;    // [m^D] weight of V_j in the second moment over D
  double particle = 0;  // its number
};

// Eight particles of a cluster.
template <int D>
struct Eight {
  Lane x[D], scale, particle;

  explicit Eight(const Place<D>* of) {
    for (int l = 0; l < base::lanes; ++l) {
      for (int a = 0; a < D; ++a) x[a][l] = of[l].x[a];
      scale[l] = of[l].scale;
      particle[l] = of[l].particle;
    }
  }
  Lane squared(const Place<D>& place) const {  // r^2 [m^2]
    Lane r2{};
    for (int a = 0; a < D; ++a) {
      const Lane d = x[a] - place.x[a];
      r2 = base::fma(d, d, r2);
    }
    return r2;
  }
};

template <int D, class Kernel>
class ByRejection final : public UnlistedJumps {
 public:
  ByRejection(const Places<D>& places, std::shared_ptr<const sph::Clusters<D>> clusters, const Kernel& kernel,
              const Habitat& habitat)
      : clusters_(std::move(clusters)), kernel_(kernel) {
    take(places, habitat);
    sum_.assign(clusters_->particles(), 0.0);
    most_.assign(sum_.size(), 0.0);
    ceiling_.assign(clusters_->size(), 0.0);
    find_near();
    each_cluster([this](std::size_t c) { scale(c); });
    for (std::size_t p = lanes * clusters_->size(); p < place_.size(); ++p)
      place_[p].scale = place_[clusters_->place(clusters_->particle(p))].scale;
    each_cluster([this](std::size_t c) { bound(c); });
  }

  std::uint32_t target(std::uint32_t i, WordStream& words) const override {
    const std::size_t own = clusters_->place(i), c = own / lanes;
    const auto near = near_of(c);
    const double step = most_[i] * 0x1p-32, ceiling = ceiling_[c];
    for (;;) {
      const auto chance = words.take(2 * lanes);
      std::uint32_t some[lanes];
      for (std::size_t l = 0; l < lanes; ++l) some[l] = near[std::uint64_t(chance[l]) * near.size() >> 32];
      const Lane weight = weigh(own, some, ceiling == 0.0);
      for (std::size_t l = 0; l < lanes; ++l) {
        if (double(chance[lanes + l]) * step >= weight[int(l)]) continue;
        if (ceiling == 0.0) return clusters_->particle(some[l]);
        const double s_i = place_[own].scale, s_j = place_[some[l]].scale;
        return double(words.take(1)[0]) * 0x1p-32 * (s_i + ceiling) < s_i + s_j ? clusters_->particle(some[l]) : i;
      }
    }
  }

  void row(std::uint32_t i, std::vector<std::uint32_t>& target, std::vector<double>& coupling) const override {
    const std::size_t own = clusters_->place(i);
    const auto near = near_of(own / lanes);
    for (std::size_t k = 0; sum_[i] > 0.0 && k < near.size(); k += lanes) {
      std::uint32_t some[lanes];
      for (std::size_t l = 0; l < lanes; ++l) some[l] = k + l < near.size() ? near[k + l] : std::uint32_t(own);
      const Lane weight = weigh(own, some, true);
      for (int l = 0; l < base::lanes; ++l) {
        if (weight[l] <= 0.0) continue;
        target.push_back(clusters_->particle(some[l]));
        coupling.push_back(weight[l]);
      }
    }
  }

 private:
  template <class Work>
  void each_cluster(Work work) const {
#pragma omp parallel for schedule(static)
    for (std::size_t c = 0; c < clusters_->size(); ++c) work(c);
  }

  std::span<const std::uint32_t> near_of(std::size_t c) const {
    return {near_.data() + first_[c], near_.data() + first_[c] + near_count_[c]};
  }
  Eight<D> eight(std::size_t c) const { return Eight<D>(place_.data() + lanes * c); }

  void take(const Places<D>& places, const Habitat& habitat) {
    const auto at = clusters_->coordinates(places.position);
    place_.resize(clusters_->places());
    for (std::size_t p = 0; p < place_.size(); ++p) {
      const std::size_t i = clusters_->particle(p);
      const bool inside = habitat.home[places.material[i]];
      Place<D>& place = place_[p];
      for (std::size_t a = 0; a < D; ++a) place.x[a] = at[a][p];
      place.area = inside ? places.area[i] : 0.0;
      place.moment = (inside ? 1.0 : 0.5) * places.area[i] / D;
      place.particle = double(i);
    }
  }

  // Of the partners, which lie within a skin of the reach, those within reach of one of the eight.
  void find_near() {
    first_.assign(clusters_->size() + 1, 0);
    near_count_.resize(clusters_->size());
    for (std::size_t c = 0; c < clusters_->size(); ++c) first_[c + 1] = first_[c] + clusters_->partners(c).size();
    near_.resize(first_.back());
    const double limit = kernel_.reach() * kernel_.reach();
    each_cluster([&](std::size_t c) {
      const auto own = eight(c);
      std::uint32_t* const near = near_.data() + first_[c];
      std::uint32_t found = 0;
      for (const std::uint32_t p : clusters_->partners(c)) {
        near[found] = p;
        found += base::any_below(own.squared(place_[p]), limit);
      }
      near_count_[c] = found;
    });
  }

  Lane F(const Lane& r2) const {
    const Lane some = r2 + tiny;
    return kernel_.F(Lane(some * base::inverse_root(some)));
  }

  // Also leaves the sum and the largest of V_j F_ij, none of a particle with itself and its images.
  void scale(std::size_t c) {
    const auto own = eight(c);
    Lane moment{}, sum{}, most{};
    for (const std::uint32_t p : near_of(c)) {
      const Place<D>& place = place_[p];
      const Lane r2 = own.squared(place), f = F(r2);
      moment = base::fma(place.moment * r2, f, moment);
      const Lane weight = own.particle != place.particle ? place.area * f : Lane{};
      sum += weight;
      most = base::larger(most, weight);
    }
    const Lane scale = moment > 0.0 ? 1.0 / moment : Lane{};
    for (std::size_t l = 0; l < lanes; ++l) place_[lanes * c + l].scale = scale[int(l)];
    keep(c, sum, most);
  }

  // From V_j F_ij to couplings: with s_j at its largest nearby, so that some jumps fail, or where that would be many,
  // one by one.
  void bound(std::size_t c) {
    double largest = 0.0;
    for (const std::uint32_t p : near_of(c)) largest = std::max(largest, place_[p].scale);
    const auto own = eight(c);
    if (base::any_below(much_alike * own.scale, largest)) return add_up(c, own);
    ceiling_[c] = largest;
    for (std::size_t l = 0; l < clusters_->count(c); ++l)
      sum_[clusters_->particle(lanes * c + l)] *= own.scale[int(l)] + largest;
  }

  void add_up(std::size_t c, const Eight<D>& own) {
    Lane sum{}, most{};
    for (const std::uint32_t p : near_of(c)) {
      const Place<D>& place = place_[p];
      const Lane weight = (own.scale + place.scale) * place.area * F(own.squared(place));
      const Lane jumps = own.particle != place.particle ? weight : Lane{};
      sum += jumps;
      most = base::larger(most, jumps);
    }
    keep(c, sum, most);
  }

  void keep(std::size_t c, const Lane& sum, const Lane& most) {
    for (std::size_t l = 0; l < clusters_->count(c); ++l) {
      const std::size_t p = lanes * c + l, i = clusters_->particle(p);
      if (place_[p].area == 0.0) continue;  // no home
      sum_[i] = sum[int(l)];
      most_[i] = most[int(l)];
    }
  }

  // c_ij, or V_j F_ij alone, between one particle's place and eight others.
  Lane weigh(std::size_t own, const std::uint32_t (&some)[lanes], bool scaled) const {
    Lane r2{}, weight, other;
    for (int a = 0; a < D; ++a) {
      Lane x;
      for (int l = 0; l < base::lanes; ++l) x[l] = place_[some[l]].x[a];
      const Lane d = place_[own].x[a] - x;
      r2 = base::fma(d, d, r2);
    }
    for (int l = 0; l < base::lanes; ++l) {
      const Place<D>& place = place_[some[l]];
      weight[l] = scaled ? (place_[own].scale + place.scale) * place.area : place.area;
      other[l] = place.particle;
    }
    return other != place_[own].particle ? weight * F(r2) : Lane{};
  }

  std::shared_ptr<const sph::Clusters<D>> clusters_;
  Kernel kernel_;
  std::vector<Place<D>> place_;
  std::vector<double> most_;     // of voxels: the largest V_j F_ij; where the ceiling is 0 the largest coupling [1/m^2]
  std::vector<double> ceiling_;  // [m^D] of clusters: the largest scaling nearby; 0 where sums are exact
  std::vector<std::uint64_t> first_;       // of clusters: where in near_ they begin,
  std::vector<std::uint32_t> near_count_;  // and how many places are theirs
  std::vector<std::uint32_t> near_;
};

}  // namespace

bool can_stay_unlisted(const Habitat& habitat) {
  const auto none = [](const std::vector<bool>& list) { return std::ranges::find(list, true) == list.end(); };
  return none(habitat.clamped) && none(habitat.source) &&
         std::ranges::all_of(habitat.side, [](SideUse use) { return use == SideUse::reflect; });
}

template <int D>
std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<D>& places,
                                                         std::shared_ptr<const sph::Clusters<D>> clusters,
                                                         const sph::AnyKernel<D>& kernel, const Habitat& habitat) {
  return std::visit(
      [&]<class Kernel>(const Kernel& one) -> std::shared_ptr<const UnlistedJumps> {
        return std::make_shared<ByRejection<D, Kernel>>(places, std::move(clusters), one, habitat);
      },
      kernel);
}

template std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<1>&,
                                                                  std::shared_ptr<const sph::Clusters<1>>,
                                                                  const sph::AnyKernel<1>&, const Habitat&);
template std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<2>&,
                                                                  std::shared_ptr<const sph::Clusters<2>>,
                                                                  const sph::AnyKernel<2>&, const Habitat&);
template std::shared_ptr<const UnlistedJumps> make_unlisted_jumps(const Places<3>&,
                                                                  std::shared_ptr<const sph::Clusters<3>>,
                                                                  const sph::AnyKernel<3>&, const Habitat&);

}  // namespace shmoo::rdme
