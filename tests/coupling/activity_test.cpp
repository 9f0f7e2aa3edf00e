// How busy a run is foretold to be.
#include "coupling/activity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

// Molecules that jump 80 times a second each and decay at 2/s: both kinds of events become rarer as exp(-2 t).
const char* const decay = R"toml(
title = "Decay"
dimension = 1
cross_section = "1 um^2"
[domain]
size = ["50 um"]
spacing = "0.1 um"
material = "medium"
boundary = { x = "periodic" }
[materials.medium]
type = "still"
[species.A]
diffusivity = "0.4 um^2/s"
[[initial]]
species = "A"
count = "4000 molecules"
[[reaction]]
equation = "A -> nothing"
forward = "2 1/s"
[run]
until = "2 s"
record_every = "1 s"
)toml";

TEST(Activity, FallsWithTheMoleculesThatAreThere) {
  const Laboratory lab(scene::read_scene_text(decay, "decay.toml"));
  const auto activity = lab.experiment->activity([] { return false; });
  ASSERT_GT(activity.size(), 50u);
  const double dt = 2.0 / double(activity.size());
  double events = 0.0;
  for (std::size_t k = 0; k < activity.size(); ++k) {
    const double t = (double(k) + 0.5) * dt;
    EXPECT_NEAR(activity[k] / activity[0], std::exp(-2.0 * (t - 0.5 * dt)), 0.01);
    events += activity[k] * dt;
  }
  Outcome outcome;
  lab.realise(0, &outcome);
  constexpr double weight = 1.25;  // of a jump that makes one propensity anew
  EXPECT_NEAR(events, weight * double(outcome.jump_events), 0.05 * events);
}

TEST(Activity, GoesOnAsItWasWhereForetellingWasStopped) {
  const Laboratory lab(scene::read_scene_text(decay, "decay.toml"));
  int asked = 0;
  const auto activity = lab.experiment->activity([&] { return ++asked > 10; });
  ASSERT_GT(activity.size(), 50u);
  EXPECT_LT(activity[9], activity[0]);
  EXPECT_EQ(activity.back(), activity[9]);
}

}  // namespace
}  // namespace shmoo::coupling
