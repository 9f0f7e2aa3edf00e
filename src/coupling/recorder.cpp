#include "coupling/recorder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/observables.hpp"
#include "coupling/splitting.hpp"
#include "scene/motion.hpp"
#include "scene/refinement.hpp"

namespace shmoo::coupling {

template <int D>
Recorder<D>::Recorder(const scene::Scene& scene, const rdme::Network& network, const Geometry<D>& geometry,
                      std::array<std::size_t, 3> cells, std::vector<double> times, bool chemistry_shared,
                      bool flow_shared)
    : scene_(scene), geometry_(geometry), material_(geometry.material()) {
  layout_.times = std::move(times);
  add_chemistry_fields(network, chemistry_shared, flow_shared);
  if (scene::in_motion(scene)) add_flow_fields(flow_shared);
  refuse_unknown_names();
  for (const auto& observable : scene.observables) {
    FieldInfo info = describe(observable, scene, cells[std::size_t(observable.axis)]);
    info.shared = of_chemistry(observable.type) ? chemistry_shared : flow_shared;
    layout_.observables.push_back(std::move(info));
  }
}

template <int D>
void Recorder<D>::add_field(FieldInfo info, FieldSource source) {
  available_.push_back(info.name);
  const auto& wanted = scene_.run.record;
  if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), info.name) == wanted.end()) return;
  layout_.fields.push_back(std::move(info));
  sources_.push_back(source);
}

template <int D>
void Recorder<D>::add_chemistry_fields(const rdme::Network& network, bool shared, bool flow_shared) {
  const auto reference = reference_concentrations(scene_);
  const double voxel = std::pow(scene_.domain.spacing, D) * scene_.depth;
  for (std::size_t s = 0; s < network.species(); ++s) {
    FieldInfo info{
        scene_.species[s].name, "molecules", network.stochastic(int(s)), shared, {material_.size()}, 1.0, {}};
    info.scale = std::max(1.0, reference[s] * voxel);
    add_field(std::move(info), {Source::species, int(s)});
  }
  if (network.species() > 0)
    add_field({"volume", "m^3", false, flow_shared, {material_.size()}, voxel, {}}, {Source::volume});
}

template <int D>
void Recorder<D>::add_flow_fields(bool shared) {
  const std::size_t n = material_.size(), d = D;
  double length = 0.0, density = 0.0;
  for (int a = 0; a < D; ++a)
    length = std::max(length, scene_.domain.upper[std::size_t(a)] - scene_.domain.lower[std::size_t(a)]);
  for (const auto& material : scene_.materials) density = std::max(density, material.density);
  const double speed = scene_.flow.reference_speed.value_or(1.0);
  add_field({"position", "m", false, shared, {n, d}, length, {}}, {Source::position});
  add_field({"velocity", "m/s", false, shared, {n, d}, speed, {}}, {Source::velocity});
  add_field({"density", "kg/m^3", false, shared, {n}, density, {}}, {Source::density});
  if (scene::particles_come_and_go(scene_))
    add_field({"particle", "1", false, shared, {n}, 1.0, {}}, {Source::particle});
  add_field({"pressure", "Pa", false, shared, {n}, density * speed * speed, {}}, {Source::pressure});
}

template <int D>
void Recorder<D>::refuse_unknown_names() const {
  for (const auto& name : scene_.run.record) {
    if (std::find(available_.begin(), available_.end(), name) != available_.end()) continue;
    throw base::InputError({{{scene_.file, 0, 0},
                             fmt::format("run.record names '{}', which this scene does not have; it has: {}", name,
                                         fmt::join(available_, ", "))}});
  }
}

template <int D>
void Recorder<D>::volume(std::size_t time, const Frame<D>& frame, RecordSink& sink) const {
  for (std::size_t f = 0; f < sources_.size(); ++f) {
    if (sources_[f].source != Source::volume) continue;
    std::vector<double> volume(frame.arrival_capacity);
    for (double& v : volume) v *= scene_.depth;
    sink.field(time, f, Values(std::span<const double>(volume)));
  }
}

template <int D>
void Recorder<D>::chemistry(std::size_t time, const rdme::State& state, const Frame<D>& frame, RecordSink& sink) const {
  std::vector<std::int64_t> whole;
  std::vector<double> real;
  for (std::size_t f = 0; f < sources_.size(); ++f) {
    if (sources_[f].source != Source::species) continue;
    whole.clear();
    real.clear();
    for (std::size_t i = 0; i < material_.size(); ++i) {
      const std::size_t entry = i * state.species + std::size_t(sources_[f].species);
      if (layout_.fields[f].whole)
        whole.push_back(state.count[entry]);
      else
        real.push_back(state.amount[entry]);
    }
    if (layout_.fields[f].whole)
      sink.field(time, f, Values(std::span<const std::int64_t>(whole)));
    else
      sink.field(time, f, Values(std::span<const double>(real)));
  }
  for (std::size_t o = 0; o < scene_.observables.size(); ++o) {
    if (!of_chemistry(scene_.observables[o].type)) continue;
    const FieldInfo& info = layout_.observables[o];
    measure_chemistry<D>(scene_.observables[o], scene_, info, state, frame, geometry_, whole, real);
    if (info.whole)
      sink.observable(time, o, Values(std::span<const std::int64_t>(whole)));
    else
      sink.observable(time, o, Values(std::span<const double>(real)));
  }
}

template <int D>
void Recorder<D>::flow(std::size_t time, const FlowPicture<D>& picture, RecordSink& sink) const {
  const auto flat = [](const std::vector<base::Vec<D>>& v) {
    return std::span<const double>(v.empty() ? nullptr : v.front().data(), v.size() * D);
  };
  for (std::size_t f = 0; f < sources_.size(); ++f) {
    switch (sources_[f].source) {
      case Source::position:
        sink.field(time, f, Values(flat(picture.position)));
        break;
      case Source::velocity:
        sink.field(time, f, Values(flat(picture.velocity)));
        break;
      case Source::density:
        sink.field(time, f, Values(std::span<const double>(picture.density)));
        break;
      case Source::pressure:
        sink.field(time, f, Values(std::span<const double>(picture.pressure)));
        break;
      case Source::particle:
        sink.field(time, f, Values(std::span<const double>(picture.particle)));
        break;
      case Source::species:
      case Source::volume:
        break;
    }
  }
  std::vector<double> real;
  for (std::size_t o = 0; o < scene_.observables.size(); ++o) {
    if (of_chemistry(scene_.observables[o].type)) continue;
    measure_flow<D>(scene_.observables[o], scene_, layout_.observables[o], picture, material_, real, o);
    sink.observable(time, o, Values(std::span<const double>(real)));
  }
}

template class Recorder<1>;
template class Recorder<2>;
template class Recorder<3>;

}  // namespace shmoo::coupling
