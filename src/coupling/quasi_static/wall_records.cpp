#include "coupling/quasi_static/wall_records.hpp"

#include <algorithm>

#include "coupling/observables.hpp"
#include "coupling/splitting.hpp"

namespace shmoo::coupling {
namespace {

using scene::ObservableType;

constexpr int volume = -1, position = -2, hoop_strain = -3, hoop_stress = -4;  // for a species
constexpr double window = 0.1;  // [outer radii] of arc on either side, for curvatures

// The particles as observables of chemistry see them.
Frame<2> frame_of(const WallPlan& plan, const Wall& wall) {
  Frame<2> frame;
  for (const auto& x : wall.shell().x) frame.arrival.emplace_back(plan.centre + x[0], x[1]);
  for (const double v : wall.volumes()) frame.arrival_capacity.push_back(v / plan.scene.depth);
  const double share = wall.cavity_volume() / double(std::max<std::size_t>(1, wall.filling().size()));
  for (const auto& x : wall.filling()) {
    frame.arrival.emplace_back(plan.centre + x[0], x[1]);
    frame.arrival_capacity.push_back(share / plan.scene.depth);
  }
  return frame;
}

}  // namespace

WallRecords::WallRecords(const WallPlan& plan, const rdme::Network& network, std::vector<double> times, bool shared)
    : plan_(plan), material_(plan.start.size(), std::uint16_t(plan.material)) {
  material_.resize(plan.start.size() + plan.filling.size(), std::uint16_t(plan.filling_material));
  layout_.times = std::move(times);
  add_fields(network, shared);
  for (const auto& observable : plan.scene.observables) {
    auto info = describe(observable, plan.scene, std::size_t(plan.start.columns));
    info.shared = shared;
    layout_.observables.push_back(std::move(info));
  }
}

void WallRecords::add_fields(const rdme::Network& network, bool shared) {
  const auto& scene = plan_.scene;
  const auto add = [&](FieldInfo info, int species) {
    const auto& wanted = scene.run.record;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), info.name) == wanted.end()) return;
    layout_.fields.push_back(std::move(info));
    species_.push_back(species);
  };
  const std::size_t n = material_.size();
  const double voxel = plan_.real_volume(plan_.start.V0[plan_.start.size() / 2]);
  const auto reference = reference_concentrations(scene);
  for (std::size_t s = 0; s < scene.species.size(); ++s)
    add({scene.species[s].name,
         "molecules",
         network.stochastic(int(s)),
         shared,
         {n},
         std::max(1.0, reference[s] * voxel),
         {}},
        int(s));
  add({"volume", "m^3", false, shared, {n}, voxel, {}}, volume);
  add({"position", "m", false, shared, {n, 2}, plan_.ring.outer, {}}, position);
  add({"hoop_strain", "1", false, shared, {n}, 1.0, {}}, hoop_strain);
  add({"hoop_stress", "Pa", false, shared, {n}, plan_.elastic().shear_modulus, {}}, hoop_stress);
}

double WallRecords::shape(ObservableType type, const Wall& wall) const {
  const auto outline = wall.outer_surface();
  const double R = plan_.ring.outer;
  switch (type) {
    case ObservableType::projection_length:
      return hydro::length_along_axis(outline) - plan_.length;
    case ObservableType::tip_curvature:
      return hydro::tip_curvature(outline, window * R);
    case ObservableType::flank_curvature:
      return hydro::least_curvature(outline, window * R) * R;
    case ObservableType::cavity_volume:
      return wall.cavity_volume();
    case ObservableType::residual:
      return wall.largest_residual();
    default:
      return double(wall.outside());
  }
}

void WallRecords::read(std::size_t time, const Wall& wall, const rdme::State& state, RecordSink& sink) const {
  const auto frame = frame_of(plan_, wall);
  std::vector<std::int64_t> whole;
  std::vector<double> real;
  const auto send = [&](bool as_whole, const auto& to) {
    if (as_whole)
      to(Values(std::span<const std::int64_t>(whole)));
    else
      to(Values(std::span<const double>(real)));
  };
  for (std::size_t f = 0; f < species_.size(); ++f) {
    whole.clear(), real.clear();
    for (std::size_t i = 0; i < material_.size(); ++i) {
      const std::size_t entry = i * state.species + std::size_t(std::max(0, species_[f]));
      if (species_[f] == volume)
        real.push_back(frame.arrival_capacity[i] * plan_.scene.depth);
      else if (species_[f] == position)
        real.insert(real.end(), {frame.arrival[i][0], frame.arrival[i][1]});
      else if (species_[f] == hoop_strain)
        real.push_back(i < plan_.start.size() ? wall.hoop(i).strain : 0.0);
      else if (species_[f] == hoop_stress)
        real.push_back(i < plan_.start.size() ? wall.hoop(i).stress : 0.0);
      else if (layout_.fields[f].whole)
        whole.push_back(state.count[entry]);
      else
        real.push_back(state.amount[entry]);
    }
    send(layout_.fields[f].whole, [&](Values values) { sink.field(time, f, values); });
  }
  for (std::size_t o = 0; o < plan_.scene.observables.size(); ++o) {
    const auto& observable = plan_.scene.observables[o];
    const auto& info = layout_.observables[o];
    if (of_chemistry(observable.type))
      measure_sums<2>(observable, plan_.scene, info, state, frame, material_, whole, real);
    else
      real = {shape(observable.type, wall)};
    send(info.whole, [&](Values values) { sink.observable(time, o, values); });
  }
}

}  // namespace shmoo::coupling
