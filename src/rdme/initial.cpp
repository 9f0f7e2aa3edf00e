#include "rdme/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.hpp"
#include "rdme/expression.hpp"

namespace shmoo::rdme {
namespace {

constexpr double largest_count = 0x1p53;

class Filling {
 public:
  Filling(const scene::Scene& scene, const Network& network, const Voxels& voxels, const base::RandomKey& key)
      : scene_(scene), network_(network), voxels_(voxels), key_(key), state_(empty_state(network, voxels.size())) {}

  State run() {
    for (int s = 0; s < static_cast<int>(network_.species()); ++s) fill(s);
    open_ledger(state_, network_);
    return std::move(state_);
  }

 private:
  // The entry that holds in each voxel, -1 for none.
  std::vector<int> entries_of(int species) const {
    std::vector<int> entry(voxels_.size(), -1);
    for (std::size_t k = 0; k < scene_.initials.size(); ++k) {
      const scene::Initial& initial = scene_.initials[k];
      if (initial.species != species) continue;
      bool any = false;
      for (std::size_t i = 0; i < voxels_.size(); ++i) {
        const int material = voxels_.material[i];
        if (!network_.lives_in(species, material) || (initial.material >= 0 && initial.material != material)) continue;
        if (initial.shape && !scene::contains(*initial.shape, voxels_.position[i], scene_.dimension)) continue;
        entry[i] = static_cast<int>(k);
        any = true;
      }
      if (!any) {
        refuse(species, "covers no particle of its homes; look at its shape and material, or at the spacing");
      }
    }
    return entry;
  }

  [[noreturn]] void refuse(int species, const std::string& why) const {
    throw base::InputError(fmt::format("an initial amount of species {} {}", network_.name(species), why));
  }

  void fill(int species) {
    const std::vector<int> entry = entries_of(species);
    for (std::size_t k = 0; k < scene_.initials.size(); ++k) {
      const scene::Initial& initial = scene_.initials[k];
      if (initial.species != species) continue;
      std::vector<std::size_t> covered;
      for (std::size_t i = 0; i < voxels_.size(); ++i) {
        if (entry[i] == static_cast<int>(k)) covered.push_back(i);
      }
      if (initial.count) {
        spread(species, static_cast<std::uint64_t>(k), *initial.count, covered);
      } else {
        concentrate(species, initial.concentration, covered);
      }
    }
  }

  void concentrate(int species, const scene::Quantity& concentration, const std::vector<std::size_t>& covered) {
    std::unique_ptr<Expression> expression;
    if (!concentration.expression.empty()) {
      expression = std::make_unique<Expression>(concentration.expression, ExpressionNames{network_.parameters(), {}});
    }
    for (std::size_t i : covered) {
      double value = concentration.value;
      const auto& x = voxels_.position[i];
      if (expression) {
        expression->set_position(x[0], x[1], x[2]);
        value = expression->value();
      }
      if (!(value >= 0 && value * voxels_.volume[i] < largest_count)) {
        refuse(species,
               fmt::format("is {} molecules/m^3 at ({}, {}, {}) m; it must be >= 0 and give fewer than 2^53 molecules",
                           value, x[0], x[1], x[2]));
      }
      const double molecules = value * voxels_.volume[i];
      if (!network_.stochastic(species)) {
        state_.amount[i * state_.species + species] = molecules;
        continue;
      }
      base::RandomSequence random(key_, base::Stream::initial_counts, 0, static_cast<std::uint32_t>(species),
                                  static_cast<std::uint32_t>(i));
      const double whole = std::floor(molecules);
      state_.count[i * state_.species + species] =
          static_cast<std::int64_t>(whole) + (random.uniform() < molecules - whole ? 1 : 0);
    }
  }

  void spread(int species, std::uint64_t entry, double count, const std::vector<std::size_t>& covered) {
    double volume = 0;
    for (std::size_t i : covered) volume += voxels_.volume[i];
    if (!(count >= 0 && count < largest_count))
      refuse(species, fmt::format("is {} molecules; it must be >= 0 and < 2^53", count));
    if (covered.empty() && count > 0) refuse(species, "has a count, but later entries take all that it covers");
    if (!network_.stochastic(species)) {
      for (std::size_t i : covered) state_.amount[i * state_.species + species] = count * (voxels_.volume[i] / volume);
      return;
    }
    if (count != std::floor(count)) {
      refuse(species, fmt::format("is {} molecules; the count of a stochastic species must be a whole number", count));
    }
    base::RandomSequence random(key_, base::Stream::initial_counts, 1 + entry, static_cast<std::uint32_t>(species));
    auto left = static_cast<std::int64_t>(count);
    for (std::size_t k = 0; k < covered.size(); ++k) {
      const double v = voxels_.volume[covered[k]];
      const bool last = k + 1 == covered.size();
      const std::int64_t here = last ? left : base::binomial(random, left, std::min(1.0, v / volume));
      state_.count[covered[k] * state_.species + species] = here;
      left -= here;
      volume -= v;
    }
  }

  const scene::Scene& scene_;
  const Network& network_;
  const Voxels& voxels_;
  const base::RandomKey& key_;
  State state_;
};

}  // namespace

State initial_state(const scene::Scene& scene, const Network& network, const Voxels& voxels,
                    const base::RandomKey& key) {
  return Filling(scene, network, voxels, key).run();
}

}  // namespace shmoo::rdme
