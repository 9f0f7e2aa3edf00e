#pragma once
// Events of a well: when their triggers turn true, what waits until its delay is over, and what is then set (SBML L3V2,
// section 4.11). Exact: between reaction events only the time changes, and the times at which a trigger can turn by it
// are found to the last bit (timed_rate.hpp); after each reaction event triggers that read amounts are looked at again;
// where amounts are integrated, what they are compared with is a root function of the integrator.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rdme/deterministic.hpp"
#include "rdme/sampler.hpp"
#include "rdme/time/timed_rate.hpp"

namespace shmoo::rdme {

class EventClock final : public EventWatch, public RootWatch {
 public:
  // A scene in numbers (scene/well.hpp). Throws base::InputError: a formula that cannot be used, or a trigger that
  // reads amounts of smooth species where others are sampled. The network must outlive it.
  EventClock(const scene::Scene& scene, const Network& network);

  bool any() const { return !events_.empty(); }
  bool reads_amounts() const { return reads_amounts_; }  // some trigger does

  // A new realisation. The state must outlive its run, and stay the same object.
  void begin(State& state);

  // The first time in (t, end] at which something is due, or a trigger turns if the amounts stay as they are; infinite
  // where there is none. [s]
  double next(double t, double end);

  // Makes all that is due at t; true where that changed amounts or parameters. Throws base::RunError where a value
  // cannot be set, or events set one another off without end.
  bool act(double t);

  // Around an advance of a sampler up to `end`: where it was stopped, or `end`.
  void go_on(double end) { stopped_ = end; }
  double stopped() const { return stopped_; }
  bool stops(double t) override;
  int roots() const override { return static_cast<int>(roots_.size()); }
  void distances(double t, const State& state, double* values) override;
  bool at_a_root(double t);  // some comparison of integrated amounts stands at equality

 private:
  struct Target {
    int species = -1, parameter = -1;  // one of them; a parameter by its place in State::parameter
    Expression value;
  };
  struct Event {
    std::string name;
    std::unique_ptr<Expression> trigger, delay, priority;  // delay and priority: null where there is none
    TimedRate turns;                                       // the trigger, for the times at which it may turn
    std::vector<Target> targets;
    bool initially, persistent, values_at_trigger;
    bool reads_time = false, reads_amounts = false;
    bool holds = false;  // what the trigger was when last looked at
  };
  struct Waiting {
    std::size_t event;
    double due;                  // [s]
    std::vector<double> values;  // of its targets, where they are of the trigger's moment
  };

  void add(const scene::Event& from, const scene::Scene& scene);
  double value(Expression& formula, double t);
  bool holds(Event& event, double t) { return value(*event.trigger, t) != 0.0; }
  std::vector<double> values(Event& event, double t);
  void look(double t);
  bool make_one(double t);
  void set(const Event& event, const Target& target, double value, double t);
  double first_turn(Event& event, double t, double end);

  const Network& network_;
  State* state_ = nullptr;
  std::vector<Event> events_;
  std::vector<Waiting> waiting_;                    // in the order of their triggers
  std::vector<Expression> roots_;                   // where all amounts are integrated
  double stopped_ = 0;                              // [s]
  bool smooth_ = false;                             // all amounts are integrated
  bool reads_amounts_ = false, any_mixed_ = false;  // mixed: a trigger reads both amounts and the time
};

}  // namespace shmoo::rdme
