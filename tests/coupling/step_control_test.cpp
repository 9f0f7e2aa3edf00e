// Macro steps of a wall by error control: they follow what happens, cost the length what the tolerance says, and stay
// out of the way where the scene gives a step or realisations are random.
#include "coupling/quasi_static/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

scene::Scene case_1(const scene::Overrides& more) {
  scene::Overrides all{{"domain.spacing", "\"0.8 um\""},
                       {"mechanics.columns", "40"},
                       {"run.until", "\"300 s\""},
                       {"run.record_every", "\"300 s\""}};
  all.insert(all.end(), more.begin(), more.end());
  return scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/yeast-projection/case-1.toml", all);
}

struct Course {
  double length = 0, error = 0;  // [m]
  int steps = 0;
};

// Explicit Euler's steps for a length that tends from 1 to 2 m in a time of 10 s.
Course follow(double tolerance) {
  auto scene = case_1({});
  scene.mechanics.tolerance = tolerance;
  StepControl control(scene, false);
  Course course{1.0, 0.0, 0};
  for (double t = 0.0; t < scene.run.until; ++course.steps) {
    const double dt = std::min(control.step(), scene.run.until - t), change = dt * (2.0 - course.length) / 10.0;
    course.length += change;
    course.error = std::max(course.error, std::abs(course.length - 2.0 + std::exp(-(t + dt) / 10.0)));
    control.learn(dt, change, course.length);
    t += dt;
  }
  return course;
}

TEST(StepControl, CostsWhatTheToleranceSays) {
  for (const double tolerance : {1e-2, 1e-3}) EXPECT_LT(follow(tolerance).error, 2.0 * tolerance) << tolerance;
  EXPECT_GT(follow(1e-3).steps, 2 * follow(1e-2).steps);
}

TEST(StepControl, LeavesGivenStepsAndRandomRealisationsAlone) {
  for (const bool given : {true, false}) {
    const auto scene = case_1(given ? scene::Overrides{{"mechanics.step", "\"7 s\""}} : scene::Overrides{});
    StepControl control(scene, !given);
    const double step = control.step();
    control.learn(step, 1e-6, 1e-5);
    EXPECT_FALSE(control.controlled());
    EXPECT_EQ(control.step(), step);
  }
}

double extension(const std::string& tolerance) {
  const Laboratory lab(case_1({{"mechanics.tolerance", tolerance}}));
  return lab.shared.observed("projection_length", 1)[0];
}

// 20 um from tip to back: of which the tolerance is a part.
TEST(StepControl, TheWallsLengthIsOffByAtMostTheTolerance) {
  const double fine = extension("1e-4"), coarse = extension("1e-3"), loose = extension("1e-2");
  EXPECT_LT(std::abs(coarse - fine), 1e-3 * 20e-6);
  EXPECT_LT(std::abs(loose - fine), 1e-2 * 20e-6);
  EXPECT_NE(coarse, fine);
}

}  // namespace
}  // namespace shmoo::coupling
