// Events in a well against exact laws: their times, their order, what they do to the ledger.
#include <gtest/gtest.h>

#include "rdme/event_clock.hpp"
#include "rdme/initial.hpp"

namespace shmoo::rdme {
namespace {

// A well without reactions: X = 100 molecules, and parameters a = 1 and b = 0 that events may set.
struct Bench {
  explicit Bench(std::vector<scene::Event> events) {
    said.materials.emplace_back().name = "well";
    said.compartments.push_back({"well", 1.0});
    said.parameters = {{"a", 1.0}, {"b", 0.0}};
    scene::Species x;
    x.name = "X";
    x.homes = {0};
    x.compartment = 0;
    said.species = {x};
    scene::Initial start;
    start.count = 100.0;
    said.initials = {start};
    said.events = std::move(events);
    network = std::make_unique<Network>(said);
    clock = std::make_unique<EventClock>(said, *network);
    Voxels voxels;
    voxels.volume = {1.0};
    voxels.material = {0};
    voxels.position = {{0.0, 0.0, 0.0}};
    voxels.graph_of_species = {-1};
    state = initial_state(said, *network, voxels, {});
    clock->begin(state);
    clock->act(0.0);
  }
  // Runs all events up to `end`; returns their times.
  std::vector<double> run(double end) {
    std::vector<double> times;
    for (double t = 0; (t = clock->next(t, end)) <= end;)
      if (clock->act(t)) times.push_back(t);
    return times;
  }
  scene::Scene said;
  std::unique_ptr<Network> network;
  std::unique_ptr<EventClock> clock;
  State state;
};

scene::Event event(const std::string& name, const std::string& trigger, std::vector<scene::Assignment> set) {
  scene::Event one;
  one.name = name;
  one.trigger = trigger;
  one.assignments = std::move(set);
  return one;
}

TEST(EventClock, FindsTimesToTheLastBit) {
  Bench at({event("at", "t >= 22.5", {{"X", "7"}})});
  EXPECT_EQ(at.run(50), std::vector<double>{22.5});
  EXPECT_EQ(at.state.count[0], 7);
  EXPECT_EQ(imbalance(at.state, *at.network), "");
  Bench after({event("after", "t > 22.5", {{"X", "7"}})});
  EXPECT_EQ(after.run(50), std::vector<double>{std::nextafter(22.5, 50.0)});
}

TEST(EventClock, FindsTimesThatDependOnAmounts) {
  Bench bench({event("a", "X < 10*t", {{"X", "X + 100"}})});
  const auto times = bench.run(45);
  ASSERT_EQ(times.size(), 4u);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], 10.0 * double(k + 1), 1e-12);
}

TEST(EventClock, WhatIsTrueAtTheStartHappensOnlyWhereAskedFor) {
  Bench quiet({event("a", "X > 50", {{"X", "1"}})});
  EXPECT_EQ(quiet.state.count[0], 100);
  scene::Event loud = event("a", "X > 50", {{"X", "1"}});
  loud.initially = false;
  EXPECT_EQ(Bench({loud}).state.count[0], 1);
}

TEST(EventClock, DelaysReadValuesAtTheTriggerOrAtTheEvent) {
  const auto run = [](bool at_trigger) {
    scene::Event late = event("late", "t >= 10", {{"X", "50*a"}});
    late.delay = "5";
    late.values_at_trigger = at_trigger;
    Bench bench({late, event("change", "t >= 12", {{"a", "3"}})});
    EXPECT_EQ(bench.run(20), (std::vector<double>{10 + 2.0, 15.0}));
    return bench.state.count[0];
  };
  EXPECT_EQ(run(true), 50);
  EXPECT_EQ(run(false), 150);
}

TEST(EventClock, WhatDoesNotPersistIsCancelled) {
  const auto run = [](bool persistent) {
    scene::Event late = event("late", "t >= 10 && a > 0", {{"X", "0"}});
    late.delay = "5";
    late.persistent = persistent;
    Bench bench({late, event("off", "t >= 12", {{"a", "0"}})});
    bench.run(20);
    return bench.state.count[0];
  };
  EXPECT_EQ(run(true), 0);
  EXPECT_EQ(run(false), 100);
}

TEST(EventClock, TheHighestPriorityGoesFirst) {
  scene::Event low = event("low", "t >= 10", {{"X", "X + 1"}}), high = event("high", "t >= 10", {{"X", "X*2"}});
  low.priority = "1";
  high.priority = "a + 1";
  low.values_at_trigger = high.values_at_trigger = false;
  Bench bench({low, high});
  bench.run(20);
  EXPECT_EQ(bench.state.count[0], 201);
}

TEST(EventClock, OneEventSetsOffAnother) {
  Bench bench({event("first", "t >= 10", {{"b", "1"}}), event("second", "b > 0", {{"X", "X - 1"}, {"b", "0"}})});
  EXPECT_EQ(bench.run(20), std::vector<double>{10.0});
  EXPECT_EQ(bench.state.count[0], 99);
  EXPECT_EQ(bench.state.parameter[0], 0.0);
}

TEST(EventClock, EndlessChainsAndBrokenMoleculesAreRefused) {
  Bench endless({event("up", "a > 0 && t >= 1", {{"a", "0"}}), event("down", "a <= 0", {{"a", "1"}})});
  EXPECT_THROW(endless.run(2), base::RunError);
  Bench broken({event("half", "t >= 1", {{"X", "2.5"}})});
  EXPECT_THROW(broken.run(2), base::RunError);
  Bench negative({event("none", "t >= 1", {{"X", "-1"}})});
  EXPECT_THROW(negative.run(2), base::RunError);
}

}  // namespace
}  // namespace shmoo::rdme
