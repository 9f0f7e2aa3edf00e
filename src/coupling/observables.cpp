#include "coupling/observables.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/line_sample.hpp"
#include "sph/fill.hpp"

namespace shmoo::coupling {
namespace {

using scene::ObservableType;

template <int D>
scene::Point point_of(const base::Vec<D>& x) {
  scene::Point point{};
  for (int a = 0; a < D; ++a) point[std::size_t(a)] = x[a];
  return point;
}

// Whether the observable looks at what stands at x in this material.
template <int D>
bool selects(const scene::Observable& observable, const scene::Scene& scene, std::uint16_t material,
             const base::Vec<D>& x) {
  if (observable.material >= 0 && observable.material != int(material)) return false;
  if (observable.material < 0 && observable.species >= 0) {
    const auto& homes = scene.species[std::size_t(observable.species)].homes;
    if (std::find(homes.begin(), homes.end(), int(material)) == homes.end()) return false;
  }
  return !observable.shape || scene::contains(*observable.shape, point_of<D>(x), D);
}

// Whether no particle has this place now, in a domain with open sides.
template <int D>
bool vacant(const FlowPicture<D>& picture, std::size_t place) {
  return std::isnan(picture.position[place][0]);
}

std::size_t bin_of(double x, const scene::Scene& scene, int axis, std::size_t bins) {
  const double from = scene.domain.lower[std::size_t(axis)], to = scene.domain.upper[std::size_t(axis)];
  const double b = std::floor((x - from) / (to - from) * double(bins));
  return static_cast<std::size_t>(std::clamp(b, 0.0, double(bins) - 1.0));
}

// A bin that nothing fell into takes the value of the nearest bin that something did.
void fill_gaps(std::vector<double>& value, const std::vector<double>& weight) {
  const auto n = static_cast<long>(value.size());
  for (long b = 0; b < n; ++b) {
    if (weight[std::size_t(b)] > 0.0) continue;
    for (long away = 1; away < n; ++away) {
      const long left = b - away, right = b + away;
      if (left >= 0 && weight[std::size_t(left)] > 0.0) {
        value[std::size_t(b)] = value[std::size_t(left)];
        break;
      }
      if (right < n && weight[std::size_t(right)] > 0.0) {
        value[std::size_t(b)] = value[std::size_t(right)];
        break;
      }
    }
  }
}

double largest_concentration(const scene::Scene& scene, int species) {
  double largest = 0.0;
  for (const auto& initial : scene.initials)
    if (initial.species == species) largest = std::max(largest, initial.concentration.value);
  for (const auto& boundary : scene.boundaries)
    if (boundary.species == species && boundary.type == scene::BoundaryType::fixed)
      largest = std::max(largest, boundary.value);
  for (const auto& inflow : scene.inflows)
    for (const auto& [which, target] : inflow.species)
      if (which == species) largest = std::max(largest, target);
  for (const auto& axis : scene.domain.sides)
    for (const auto& side : axis)
      for (const auto& [which, concentration] : side.species)
        if (which == species) largest = std::max(largest, concentration);
  return largest;
}

FieldInfo profile(FieldInfo info, const scene::Observable& observable, const scene::Scene& scene, std::size_t cells) {
  const std::size_t bins = observable.bins > 0 ? std::size_t(observable.bins) : cells;
  const auto a = std::size_t(observable.axis);
  const double width = (scene.domain.upper[a] - scene.domain.lower[a]) / double(bins);
  info.shape = {bins};
  for (std::size_t b = 0; b < bins; ++b) info.axis.push_back(scene.domain.lower[a] + (double(b) + 0.5) * width);
  return info;
}

// Of the solid particles that started in the observable's shape; 0 where none did.
template <int D>
double mean_displacement(const scene::Observable& observable, const scene::Scene& scene, const FlowPicture<D>& picture,
                         const std::vector<std::uint16_t>& material) {
  const auto box = sph::domain_box<D>(scene.domain);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < picture.displacement.size(); ++i) {
    if (scene.materials[material[i]].type != scene::MaterialType::solid) continue;
    const base::Vec<D> start = box.wrap(picture.position[i] - picture.displacement[i]);
    if (!selects<D>(observable, scene, material[i], start)) continue;
    sum += picture.displacement[i][observable.component];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

FieldInfo line(FieldInfo info, const scene::Observable& observable, const scene::Scene& scene, std::size_t cells) {
  if (observable.at.empty()) return profile(std::move(info), observable, scene, cells);
  info.shape = {observable.at.size()};
  info.axis = observable.at;
  return info;
}

template <int D>
void sample_line(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                 const Scatter<D>& scatter, std::vector<double>& reals) {
  const auto box = sph::domain_box<D>(scene.domain);
  base::Vec<D> point;
  for (int a = 0; a < D; ++a) point[a] = observable.point[std::size_t(a)];
  reals.clear();
  for (const double x : info.axis) {
    point[observable.axis] = x;
    reals.push_back(sample_at<D>(scatter, box, point, 3.0 * scene.domain.spacing));
  }
}

}  // namespace

bool of_chemistry(ObservableType type) {
  return type == ObservableType::count || type == ObservableType::concentration || type == ObservableType::profile ||
         type == ObservableType::species_line || type == ObservableType::species_flux;
}

FieldInfo describe(const scene::Observable& observable, const scene::Scene& scene, std::size_t cells) {
  FieldInfo info;
  info.name = observable.name;
  switch (observable.type) {
    case ObservableType::count:
      info.unit = "molecules";
      info.whole = scene.species[std::size_t(observable.species)].method == scene::SpeciesMethod::stochastic;
      info.scale = 1e6;
      return info;
    case ObservableType::concentration:
    case ObservableType::profile:
      info.unit = "molecules/m^3";
      info.scale = std::max(largest_concentration(scene, observable.species), 1.0);
      return observable.type == ObservableType::profile ? profile(info, observable, scene, cells) : info;
    case ObservableType::kinetic_energy:
    case ObservableType::temperature:
    case ObservableType::elastic_energy:
    case ObservableType::solid_energy:
      info.unit = "J";
      return info;
    case ObservableType::displacement:
      info.unit = "m";
      return info;
    case ObservableType::max_speed:
      info.unit = "m/s";
      return info;
    case ObservableType::density_error:
    case ObservableType::min_distance:
    case ObservableType::bounces:
      info.unit = "1";
      return info;
    case ObservableType::projection_length:
      info.unit = "m";
      info.scale = 1e-6;
      return info;
    case ObservableType::tip_curvature:
      info.unit = "1/m";
      info.scale = 1e6;
      return info;
    case ObservableType::cavity_volume:
      info.unit = "m^3";
      info.scale = 1e-15;
      return info;
    case ObservableType::flank_curvature:
    case ObservableType::residual:
    case ObservableType::outside:
      info.unit = "1";
      return info;
    case ObservableType::velocity_profile:
      info.unit = "m/s";
      return profile(info, observable, scene, cells);
    case ObservableType::velocity_line:
      info.unit = "m/s";
      return line(info, observable, scene, cells);
    case ObservableType::species_line:
      info.unit = "molecules/m^3";
      info.scale = std::max(largest_concentration(scene, observable.species), 1.0);
      return line(info, observable, scene, cells);
    case ObservableType::wall_force:
      info.unit = "N";
      return info;
    case ObservableType::wall_torque:
      info.unit = "N m";
      return info;
    case ObservableType::species_flux:
      info.unit = "molecules/s";
      return info;
  }
  return info;
}

// Of every voxel [molecules/m^3], at the end of the frame's interval.
template <int D>
std::vector<double> concentrations(std::size_t species, const scene::Scene& scene, const rdme::State& state,
                                   const Frame<D>& frame) {
  const bool stochastic = scene.species[species].method == scene::SpeciesMethod::stochastic;
  std::vector<double> values;
  for (std::size_t i = 0; i < frame.arrival.size(); ++i) {
    const std::size_t entry = i * state.species + species;
    const double amount = stochastic ? double(state.count[entry]) : state.amount[entry];
    values.push_back(amount / (frame.arrival_capacity[i] * scene.depth));
  }
  return values;
}

template <int D>
void measure_sums(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                  const rdme::State& state, const Frame<D>& frame, const std::vector<std::uint16_t>& material,
                  std::vector<std::int64_t>& counts, std::vector<double>& reals) {
  const bool stochastic = scene.species[std::size_t(observable.species)].method == scene::SpeciesMethod::stochastic;
  const std::size_t bins = info.shape.empty() ? 1 : info.shape[0];
  std::vector<std::int64_t> whole(bins, 0);
  std::vector<double> amount(bins, 0.0), volume(bins, 0.0);
  for (std::size_t i = 0; i < material.size(); ++i) {
    if (!selects<D>(observable, scene, material[i], frame.arrival[i])) continue;
    const std::size_t b = bins == 1 ? 0 : bin_of(frame.arrival[i][observable.axis], scene, observable.axis, bins);
    const std::size_t entry = i * state.species + std::size_t(observable.species);
    if (stochastic)
      whole[b] += state.count[entry];
    else
      amount[b] += state.amount[entry];
    volume[b] += frame.arrival_capacity[i] * scene.depth;
  }
  counts.clear();
  reals.clear();
  if (info.whole) {
    counts = whole;
    return;
  }
  for (std::size_t b = 0; b < bins; ++b) {
    const double total = stochastic ? double(whole[b]) : amount[b];
    const bool per_volume = observable.type != ObservableType::count;
    reals.push_back(!per_volume ? total : volume[b] > 0.0 ? total / volume[b] : 0.0);
  }
  if (observable.type == ObservableType::profile) fill_gaps(reals, volume);
}

template <int D>
void measure_chemistry(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                       const rdme::State& state, const Frame<D>& frame, const Geometry<D>& geometry,
                       std::vector<std::int64_t>& counts, std::vector<double>& reals) {
  const auto species = std::size_t(observable.species);
  const auto& material = geometry.material();
  if (observable.type == ObservableType::species_flux) {
    const auto C = concentrations<D>(species, scene, state, frame);
    reals.assign(1, geometry.flux(frame, species, observable.side, observable.material, C));
  } else if (observable.type == ObservableType::species_line) {
    const auto C = concentrations<D>(species, scene, state, frame);
    Scatter<D> scatter;
    for (std::size_t i = 0; i < C.size(); ++i) {
      if (!frame.vacant.empty() && frame.vacant[i]) continue;
      if (!selects<D>(observable, scene, material[i], frame.arrival[i])) continue;
      scatter.place.push_back(frame.arrival[i]);
      scatter.value.push_back(C[i]);
    }
    sample_line<D>(observable, scene, info, scatter, reals);
  } else {
    measure_sums<D>(observable, scene, info, state, frame, material, counts, reals);
  }
}

template <int D>
void measure_flow(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                  const FlowPicture<D>& picture, const std::vector<std::uint16_t>& material, std::vector<double>& reals,
                  std::size_t number) {
  reals.clear();
  switch (observable.type) {
    case ObservableType::kinetic_energy:
      reals.push_back(picture.kinetic_energy);
      return;
    case ObservableType::temperature:
      reals.push_back(picture.temperature);
      return;
    case ObservableType::max_speed:
      reals.push_back(picture.max_speed);
      return;
    case ObservableType::density_error:
      reals.push_back(picture.density_error);
      return;
    case ObservableType::min_distance:
      reals.push_back(picture.min_distance);
      return;
    case ObservableType::bounces:
      reals.push_back(picture.bounces);
      return;
    case ObservableType::elastic_energy:
      reals.push_back(picture.elastic_energy);
      return;
    case ObservableType::solid_energy:
      reals.push_back(picture.solid_energy);
      return;
    case ObservableType::displacement:
      reals.push_back(mean_displacement<D>(observable, scene, picture, material));
      return;
    case ObservableType::wall_force:
    case ObservableType::wall_torque:
      reals.push_back(picture.loads[number]);
      return;
    case ObservableType::velocity_line: {
      Scatter<D> scatter;
      for (std::size_t i = 0; i < picture.position.size(); ++i) {
        if (scene.materials[material[i]].type != scene::MaterialType::fluid || vacant(picture, i)) continue;
        scatter.place.push_back(picture.position[i]);
        scatter.value.push_back(picture.velocity[i][observable.component]);
      }
      return sample_line<D>(observable, scene, info, scatter, reals);
    }
    default:
      break;
  }
  const std::size_t bins = info.shape[0];
  std::vector<double> weight(bins, 0.0);
  reals.assign(bins, 0.0);
  for (std::size_t i = 0; i < picture.position.size(); ++i) {
    if (scene.materials[material[i]].type != scene::MaterialType::fluid || vacant(picture, i)) continue;
    if (!selects<D>(observable, scene, material[i], picture.position[i])) continue;
    const std::size_t b = bin_of(picture.position[i][observable.axis], scene, observable.axis, bins);
    const double share = picture.share.empty() ? 1.0 : picture.share[i];
    reals[b] += share * picture.velocity[i][observable.component];
    weight[b] += share;
  }
  for (std::size_t b = 0; b < bins; ++b)
    if (weight[b] > 0.0) reals[b] /= weight[b];
  fill_gaps(reals, weight);
}

#define SHMOO_INSTANTIATE(D)                                                                                         \
  template void measure_sums<D>(const scene::Observable&, const scene::Scene&, const FieldInfo&, const rdme::State&, \
                                const Frame<D>&, const std::vector<std::uint16_t>&, std::vector<std::int64_t>&,      \
                                std::vector<double>&);                                                               \
  template void measure_chemistry<D>(const scene::Observable&, const scene::Scene&, const FieldInfo&,                \
                                     const rdme::State&, const Frame<D>&, const Geometry<D>&,                        \
                                     std::vector<std::int64_t>&, std::vector<double>&);                              \
  template void measure_flow<D>(const scene::Observable&, const scene::Scene&, const FieldInfo&,                     \
                                const FlowPicture<D>&, const std::vector<std::uint16_t>&, std::vector<double>&,      \
                                std::size_t);
SHMOO_INSTANTIATE(1)
SHMOO_INSTANTIATE(2)
SHMOO_INSTANTIATE(3)
#undef SHMOO_INSTANTIATE

}  // namespace shmoo::coupling
