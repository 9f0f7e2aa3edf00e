#include "coupling/live_solids.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::coupling {
namespace {

template <int D>
class SolidsInMotion final : public LiveFlow<D> {
 public:
  using Vec = base::Vec<D>;

  explicit SolidsInMotion(const scene::Scene& scene) : SolidsInMotion(scene, sph::fill<D>(scene)) {}

  double interval() const override {
    const double speed = solids_.max_speed(), longest = steps_ahead_ * solids_.step_limit();
    return speed > 0.0 ? std::min(longest, most_movement * spacing_ / speed) : longest;
  }

  void feel(const std::function<double(int, std::uint32_t)>& concentration) override { solids_.soften(concentration); }

  void advance(double until, Frame<D>* frame) override {
    if (frame) frame->position = place_;
    while (time_ < until) {
      const double rest = until - time_, parts = std::max(1.0, std::ceil(rest / solids_.step_limit() * (1.0 - 1e-9)));
      solids_.advance(time_, rest / parts);
      time_ = parts == 1.0 ? until : time_ + rest / parts;
      ++steps_;
    }
    if (!frame) return;
    find_places();
    frame->arrival = place_;
    for (std::size_t i = 0; i < place_.size(); ++i)
      frame->position[i] = box_.wrap(frame->position[i] + 0.5 * box_.nearest(place_[i] - frame->position[i]));
  }

  void picture(FlowPicture<D>& picture) const override {
    picture.position = place_;
    picture.velocity.assign(place_.size(), Vec(Vec::Zero()));
    picture.density.assign(place_.size(), 0.0);
    picture.pressure.assign(place_.size(), 0.0);
    add_solids(solids_, picture);
  }

  bool steady() const override { return false; }
  std::uint64_t steps() const override { return steps_; }

  std::vector<Experiment::Derived> derived() const override {
    std::vector<hydro::Derived> numbers;
    solids_.describe(numbers);
    std::vector<Experiment::Derived> list;
    for (const auto& number : numbers) list.push_back({number.name, number.value, number.unit, number.why});
    return list;
  }

 private:
  SolidsInMotion(const scene::Scene& scene, const sph::Filling<D>& filling)
      : box_(filling.box),
        spacing_(scene.domain.spacing),
        steps_ahead_(scene.species.empty() ? 1.0 : steps_between_feelings),
        solids_(scene, filling) {
    const auto& start = filling.particles.position.values();
    place_.assign(start.begin(), start.begin() + long(filling.voxels));
  }

  void find_places() {
    for (const auto& body : solids_.bodies())
      for (std::size_t i = 0; i < body.size(); ++i) place_[body.id[i]] = solids_.position(body, i);
  }

  base::Box<D> box_;
  double spacing_, time_ = 0;
  double steps_ahead_;  // of an interval, at whose end a signal stops the run
  std::uint64_t steps_ = 0;
  hydro::Solids<D> solids_;
  std::vector<Vec> place_;  // by id
};

}  // namespace

template <int D>
std::unique_ptr<LiveFlow<D>> make_live_solids(const scene::Scene& scene) {
  return std::make_unique<SolidsInMotion<D>>(scene);
}

template <int D>
void add_solids(const hydro::Solids<D>& solids, FlowPicture<D>& picture) {
  if (solids.empty()) return;
  picture.displacement.assign(picture.position.size(), base::Vec<D>(base::Vec<D>::Zero()));
  for (const auto& body : solids.bodies()) {
    for (std::size_t i = 0; i < body.size(); ++i) {
      const std::size_t id = body.id[i];
      picture.position[id] = solids.position(body, i);
      picture.velocity[id] = body.velocity[i];
      picture.density[id] = solids.density(body, i);
      picture.pressure[id] = solids.pressure(body, i);
      picture.displacement[id] = body.displacement[i];
    }
  }
  picture.elastic_energy = solids.elastic_energy();
  picture.solid_energy = picture.elastic_energy + solids.kinetic_energy();
}

template std::unique_ptr<LiveFlow<2>> make_live_solids(const scene::Scene&);
template std::unique_ptr<LiveFlow<3>> make_live_solids(const scene::Scene&);
template void add_solids(const hydro::Solids<2>&, FlowPicture<2>&);
template void add_solids(const hydro::Solids<3>&, FlowPicture<3>&);

}  // namespace shmoo::coupling
