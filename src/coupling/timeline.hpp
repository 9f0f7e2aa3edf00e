#pragma once
// The intervals between records in the order of time, each with its geometry. Where the fluid rests or has become
// steady, all further intervals share one geometry; where the flow is the same for all realisations, its intervals are
// kept and shared.
#include <functional>
#include <memory>
#include <vector>

#include "coupling/experiment.hpp"
#include "coupling/frame.hpp"
#include "coupling/geometry.hpp"
#include "coupling/live_flow.hpp"
#include "coupling/splitting.hpp"
#include "coupling/stage.hpp"
#include "rdme/state.hpp"

namespace shmoo::coupling {

template <int D>
struct Interval {
  double begin = 0, end = 0;  // [s]
  std::uint64_t number = 0;
  std::shared_ptr<const Stage<D>> stage;    // null where the scene has no chemistry
  long record = -1;                         // index of the record at its end; -1: none
  const FlowPicture<D>* picture = nullptr;  // the flow at its end where there is a record; valid during the visit
};

template <int D>
class Timeline {
 public:
  // `flow` may be null: nothing moves. `start` are the voxels' places, `cell` what each fills [m^D]; the last `reserve`
  // of them are vacant at first.
  Timeline(const scene::Scene& scene, const StageBuilder<D>& builder, const std::vector<double>& times,
           const Step& chemistry_step, std::unique_ptr<LiveFlow<D>> flow, std::vector<base::Vec<D>> start, double cell,
           std::size_t reserve = 0);

  // Geometry and flow at time 0.
  std::shared_ptr<const Stage<D>> start() const { return start_; }
  const FlowPicture<D>* start_picture() const { return flow_ ? &picture_ : nullptr; }

  // Calls visit(interval) for all intervals; stops early, returning false, where visit returns false.
  bool run(const std::function<bool(const Interval<D>&)>& visit);

  // Tells what moves of the species, where these act back on it: amounts as they are at the end of an interval.
  void feel(const rdme::Network& network, const rdme::State& state);

  // When the flow was found steady [s]; negative: never.
  double steady_since() const { return steady_since_; }

  std::uint64_t flow_steps() const { return flow_ ? flow_->steps() : 0; }

  std::vector<Experiment::Derived> flow_told() const {
    return flow_ ? flow_->told() : std::vector<Experiment::Derived>{};
  }

  // The largest |capacity rho/m - 1| of any voxel at any end of an interval: what passed between particles, relative.
  double capacity_deviation() const { return capacity_deviation_; }

 private:
  Frame<D> first_frame(const std::vector<base::Vec<D>>& start, std::size_t reserve) const;
  Interval<D> next(double t, double target);
  Interval<D> next_moving(double t, double target);
  void pass_capacity(Frame<D>& frame, const Interval<D>& interval);
  void freeze(double t);

  const scene::Scene& scene_;
  const StageBuilder<D>& builder_;
  const std::vector<double>& times_;
  double chemistry_step_;
  std::unique_ptr<LiveFlow<D>> flow_;
  std::vector<double> capacity_;                      // [m^D] now
  std::shared_ptr<const Stage<D>> start_, standing_;  // standing_: stage of all further intervals, where nothing moves
  FlowPicture<D> picture_;
  double cell_, steady_since_ = -1.0, capacity_deviation_ = 0.0;
};

extern template class Timeline<1>;
extern template class Timeline<2>;
extern template class Timeline<3>;

}  // namespace shmoo::coupling
