#include "coupling/live_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "coupling/energy_law.hpp"
#include "coupling/live_solids.hpp"
#include "hydro/fluid.hpp"
#include "hydro/steadiness.hpp"

namespace shmoo::coupling {
namespace {

constexpr double most_looks = 100;  // at the window's pace; then at the pace of the particles

template <int D>
class FluidInMotion final : public LiveFlow<D> {
 public:
  using Vec = base::Vec<D>;

  FluidInMotion(const scene::Scene& scene, const base::RandomKey& key)
      : FluidInMotion(scene, sph::fill<D>(scene), key) {}

  double interval() const override {
    const double speed = std::max({fluid_.max_speed(), fluid_.solids().max_speed(), fluid_.scales().speed});
    const double by_motion =
        speed > 0.0 ? most_movement * fluid_.scales().spacing / speed : std::numeric_limits<double>::infinity();
    // A slow flow is steady long before its particles have moved: look often while that can be expected.
    const bool settling = tolerance_ && fluid_.time() < most_looks * window_;
    const double longest =
        fluid_.solids().soften() ? std::min(by_motion, steps_between_feelings * fluid_.dt()) : by_motion;
    return settling ? std::min(longest, window_) : longest;
  }

  void feel(const std::function<double(int, std::uint32_t)>& concentration) override {
    fluid_.solids().soften(concentration);
    if (scene_.flow.buoyancy.empty()) return;
    std::vector<double> lightness(voxels_, 0.0);
    for (const auto& buoyancy : scene_.flow.buoyancy) {
      for (std::size_t id = 0; id < voxels_; ++id)
        lightness[id] += buoyancy.expansion * (concentration(buoyancy.species, std::uint32_t(id)) - buoyancy.reference);
    }
    fluid_.buoy(std::move(lightness));
  }

  void advance(double until, Frame<D>* frame) override {
    if (!frame) {
      fluid_.advance(until);
    } else {
      const std::vector<Vec> start = by_id([&](std::size_t i) { return fluid_.particles().position[i]; });
      fluid_.begin_interval();
      fluid_.advance(until);
      frame->arrival = by_id([&](std::size_t i) { return fluid_.particles().position[i]; });
      frame->drift = by_id([&](std::size_t i) { return fluid_.mean_shift(i); });
      frame->position = start;
      if (fluid_.open_sides()) return pass(*frame), look();
      for (std::size_t i = 0; i < start.size(); ++i) {
        frame->position[i] = fluid_.box().wrap(start[i] + 0.5 * fluid_.box().nearest(frame->arrival[i] - start[i]));
      }
    }
    look();
    if (energy_) energy_->look(energy());
  }

  void picture(FlowPicture<D>& picture) const override {
    const auto& state = fluid_.state();
    picture.position = by_id([&](std::size_t i) { return fluid_.particles().position[i]; });
    picture.velocity = by_id([&](std::size_t i) { return fluid_.velocity(i); });
    picture.density = by_id([&](std::size_t i) { return state.density[i]; });
    picture.pressure = by_id([&](std::size_t i) { return state.pressure[i]; });
    if (fluid_.places()) picture.particle = by_id([&](std::size_t i) { return double(fluid_.particles().id[i]); });
    if (state.share) picture.share = by_id([&](std::size_t i) { return state.share_of(i); });
    picture.kinetic_energy = fluid_.kinetic_energy();
    picture.max_speed = fluid_.max_speed();
    picture.temperature = fluid_.temperature();
    picture.density_error = fluid_.density_error();
    picture.min_distance = fluid_.smallest_distance();
    picture.bounces = double(fluid_.bounces());
    add_solids(fluid_.solids(), picture);
    picture.loads.assign(scene_.observables.size(), 0.0);
    for (std::size_t o = 0; o < scene_.observables.size(); ++o) picture.loads[o] = load(scene_.observables[o]);
  }

  bool steady() const override { return steady_; }

  std::vector<Experiment::Derived> told() const override {
    return energy_ ? std::vector<Experiment::Derived>{energy_->told()} : std::vector<Experiment::Derived>{};
  }

  std::uint64_t steps() const override { return std::uint64_t(fluid_.steps()); }

  std::vector<Experiment::Derived> derived() const override {
    std::vector<Experiment::Derived> list;
    for (const auto& number : fluid_.derived()) list.push_back({number.name, number.value, number.unit, number.why});
    return list;
  }

 private:
  FluidInMotion(const scene::Scene& scene, sph::Filling<D> filling, const base::RandomKey& key)
      : scene_(scene),
        voxels_(filling.voxels),
        reserve_(filling.reserve),
        fluid_(scene, std::move(filling), key),
        tolerance_(scene.numerics.steady_tolerance),
        steadiness_(fluid_) {
    const auto& scales = fluid_.scales();
    const double crossing = scales.speed > 0.0 ? scales.length / scales.speed : std::numeric_limits<double>::infinity();
    const double nu = scales.kinematic_viscosity();
    const double viscous = nu > 0.0 ? scales.length * scales.length / nu : crossing;
    window_ = part_of_time_scale * std::min(crossing, viscous);
    if (tolerance_) steadiness_.measure(fluid_);
    if (undriven(scene)) energy_.emplace().look(energy());
  }

  double energy() const {
    return fluid_.kinetic_energy() + fluid_.solids().kinetic_energy() + fluid_.solids().elastic_energy();
  }

  // What voxel particles have, by id or, with open sides, by their place in records; get(i) takes the particle's index
  // in the store. What no particle has is no number.
  template <class Get>
  auto by_id(Get get) const {
    using Value = std::decay_t<decltype(get(0))>;
    std::vector<Value> values(voxels_ + reserve_, empty(Value{}));
    const auto& place = fluid_.places() ? fluid_.places()->of_particles() : fluid_.particles().id.values();
    for (std::size_t i = 0; i < fluid_.particles().size(); ++i) {
      if (place[i] < values.size()) values[place[i]] = get(i);
    }
    return values;
  }
  static double empty(double) { return std::numeric_limits<double>::quiet_NaN(); }
  static Vec empty(const Vec&) { return Vec::Constant(std::numeric_limits<double>::quiet_NaN()); }

  // Steady: over a quarter of the shortest time scale of the flow (crossing or viscous) the velocity field, at fixed
  // places, changed by less than the tolerance in the root mean square.
  void look() {
    if (!tolerance_ || fluid_.time() - looked_at_ < window_) return;
    const auto& scales = fluid_.scales();
    const double elapsed = fluid_.time() - looked_at_;
    const double change = steadiness_.measure(fluid_) * elapsed * scales.speed / scales.length;
    steady_ = change <= *tolerance_;
    looked_at_ = fluid_.time();
  }

  // Who came and went, and where the voxels of those who stayed are: inside the domain, and what is vacant far outside.
  void pass(Frame<D>& frame) const {
    frame.vacant.assign(frame.position.size(), false);
    std::vector<bool> fresh(frame.position.size(), false);
    for (const auto& passage : fluid_.open_sides()->passages()) {
      frame.passages.push_back({passage.place, passage.id, passage.side, passage.enters});
      fresh[passage.place] = true;
    }
    const auto& box = fluid_.box();
    for (std::size_t i = 0; i < frame.position.size(); ++i) {
      frame.vacant[i] = std::isnan(frame.arrival[i][0]);
      if (frame.vacant[i]) {
        frame.position[i] = frame.arrival[i] = vacancy(box, fluid_.scales().reach);
        frame.drift[i] = Vec::Zero();
        continue;
      }
      const Vec start = fresh[i] ? frame.arrival[i] : frame.position[i];
      frame.position[i] = box.wrap(start + 0.5 * box.nearest(frame.arrival[i] - start));
      frame.position[i] = frame.position[i].cwiseMax(box.lower).cwiseMin(box.upper);
    }
  }

  // What an observable of a wall's load says, 0 for any other.
  double load(const scene::Observable& observable) const {
    const bool force = observable.type == scene::ObservableType::wall_force;
    if (!force && observable.type != scene::ObservableType::wall_torque) return 0.0;
    const auto material = observable.side < 0
                              ? static_cast<std::uint16_t>(observable.material)
                              : sph::side_material(scene_.materials.size(), observable.side / 2, observable.side % 2);
    Vec about;
    for (int a = 0; a < D; ++a) about[a] = observable.point[std::size_t(a)];
    const auto load = fluid_.wall_load(material, about);
    return force ? load.force[observable.component] : load.torque[D == 2 ? 2 : observable.component];
  }

  const scene::Scene& scene_;
  std::size_t voxels_, reserve_;
  hydro::Fluid<D> fluid_;
  std::optional<double> tolerance_;
  double window_ = 0, looked_at_ = 0;
  hydro::Steadiness<D> steadiness_;
  bool steady_ = false;
  std::optional<EnergyLaw> energy_;  // where nothing drives fluid and solids
};

}  // namespace

template <int D>
std::unique_ptr<LiveFlow<D>> make_live_flow(const scene::Scene& scene, const base::RandomKey& key) {
  if constexpr (D == 1) {
    throw base::InputError({{{scene.file, 0, 0}, "a flow needs dimension = 2 or 3; in 1-D set effects.flow = false"}});
  } else {
    if (!scene.effects.flow) return make_live_solids<D>(scene);
    return std::make_unique<FluidInMotion<D>>(scene, key);
  }
}

template std::unique_ptr<LiveFlow<1>> make_live_flow(const scene::Scene&, const base::RandomKey&);
template std::unique_ptr<LiveFlow<2>> make_live_flow(const scene::Scene&, const base::RandomKey&);
template std::unique_ptr<LiveFlow<3>> make_live_flow(const scene::Scene&, const base::RandomKey&);

}  // namespace shmoo::coupling
