#include "coupling/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/schedule.hpp"

namespace shmoo::coupling {

template <int D>
Timeline<D>::Timeline(const scene::Scene& scene, const StageBuilder<D>& builder, const std::vector<double>& times,
                      const Step& chemistry_step, std::unique_ptr<LiveFlow<D>> flow, std::vector<base::Vec<D>> start,
                      double cell, std::size_t reserve)
    : scene_(scene),
      builder_(builder),
      times_(times),
      chemistry_step_(chemistry_step.value),
      flow_(std::move(flow)),
      capacity_(builder.geometry().capacities(start)),
      cell_(cell) {
  if (flow_) flow_->picture(picture_);
  if (!builder_.has_chemistry()) return;
  start_ = builder_.stage(first_frame(start, reserve));
  if (!flow_) standing_ = start_;
}

template <int D>
Frame<D> Timeline<D>::first_frame(const std::vector<base::Vec<D>>& start, std::size_t reserve) const {
  Frame<D> frame;
  frame.position = frame.arrival = start;
  frame.departure_capacity = frame.capacity = frame.arrival_capacity = capacity_;
  frame.steady = flow_ == nullptr;
  if (reserve == 0) return frame;
  const auto box = sph::domain_box<D>(scene_.domain);
  frame.vacant.assign(start.size(), false);
  for (std::size_t i = start.size() - reserve; i < start.size(); ++i) {
    frame.position[i] = frame.arrival[i] = vacancy(box, box.size().norm());
    frame.vacant[i] = true;
    frame.arrival_capacity[i] = 0.0;
  }
  return frame;
}

template <int D>
bool Timeline<D>::run(const std::function<bool(const Interval<D>&)>& visit) {
  double t = 0.0;
  std::uint64_t number = 0;
  for (std::size_t record = 1; record < times_.size(); ++record) {
    while (t < times_[record]) {
      Interval<D> interval = next(t, times_[record]);
      interval.number = number++;
      t = interval.end;
      if (t >= times_[record]) {
        interval.record = static_cast<long>(record);
        if (flow_ && steady_since_ < 0.0) flow_->picture(picture_);
        if (flow_) interval.picture = &picture_;
      }
      if (!visit(interval)) return false;
    }
  }
  return true;
}

template <int D>
void Timeline<D>::feel(const rdme::Network& network, const rdme::State& state) {
  flow_->feel([&](int species, std::uint32_t id) {
    const std::size_t entry = id * state.species + std::size_t(species);
    const double amount = network.stochastic(species) ? double(state.count[entry]) : state.amount[entry];
    return amount / (capacity_[id] * scene_.depth);
  });
}

template <int D>
Interval<D> Timeline<D>::next(double t, double target) {
  if (flow_ && steady_since_ < 0.0 && flow_->steady()) freeze(t);
  if (flow_ && steady_since_ < 0.0) return next_moving(t, target);
  Interval<D> interval;
  interval.begin = t;
  interval.end = interval_end(t, chemistry_step_, target);
  interval.stage = standing_;
  return interval;
}

// The flow goes ahead; the species follow on the particles' mean positions, with what passed between them.
template <int D>
Interval<D> Timeline<D>::next_moving(double t, double target) {
  Interval<D> interval;
  interval.begin = t;
  interval.end = interval_end(t, std::min(chemistry_step_, flow_->interval()), target);
  if (!builder_.has_chemistry()) {
    flow_->advance(interval.end, nullptr);
    return interval;
  }
  Frame<D> frame;
  flow_->advance(interval.end, &frame);
  for (const auto& passage : frame.passages) capacity_[passage.voxel] = cell_;
  frame.departure_capacity = frame.capacity = capacity_;
  frame.duration = interval.end - interval.begin;
  frame.relaxation_time = flow_->interval();
  if (builder_.geometry().carries())
    pass_capacity(frame, interval);
  else
    frame.drift.clear();
  frame.arrival_capacity = capacity_;
  for (std::size_t i = 0; i < frame.vacant.size(); ++i)
    if (frame.vacant[i]) frame.arrival_capacity[i] = 0.0;
  interval.stage = builder_.stage(std::move(frame));
  return interval;
}

// Volume that passes between voxels changes their capacities: halfway in the frame, wholly in capacity_.
template <int D>
void Timeline<D>::pass_capacity(Frame<D>& frame, const Interval<D>& interval) {
  const auto graph = builder_.geometry().carrying_graph(frame);
  for (std::size_t i = 0; i < capacity_.size(); ++i) {
    double out = 0.0;
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) out += graph.flow[p];
    const double change = out * (interval.end - interval.begin) / scene_.depth;
    frame.capacity[i] -= 0.5 * change;
    capacity_[i] -= change;
    capacity_deviation_ = std::max(capacity_deviation_, std::abs(capacity_[i] / cell_ - 1.0));
    if (capacity_[i] > 0.0) continue;
    throw base::RunError(
        fmt::format("the capacity of voxel {} fell to nothing at {:g} s: the flow leaves it faster than its "
                    "neighbours can follow; use a smaller domain.spacing",
                    i, interval.end));
  }
}

// From now on particles stand and the steady flow passes through them.
template <int D>
void Timeline<D>::freeze(double t) {
  steady_since_ = t;
  flow_->picture(picture_);
  if (!builder_.has_chemistry()) return;
  Frame<D> frame;
  frame.position = frame.arrival = picture_.position;
  frame.departure_capacity = frame.capacity = frame.arrival_capacity = capacity_;
  frame.steady = true;
  if (builder_.geometry().carries()) {
    frame.drift = picture_.velocity;
    for (auto& v : frame.drift) v = -v;
  }
  standing_ = builder_.stage(std::move(frame));
}

template class Timeline<1>;
template class Timeline<2>;
template class Timeline<3>;

}  // namespace shmoo::coupling
