// What a flow with implicit friction that starts at rest costs on the whole, told from its first steps.
#include "coupling/friction_course.hpp"

#include <gtest/gtest.h>

namespace {

using namespace shmoo;

// The mean over every step, one by one.
double mean_of_steps(const coupling::FrictionCourse& course, int steps) {
  double sum = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const double decline = course.decline - std::log(k / course.step);
    const double part = std::max(decline, course.least_decline) / course.decline;
    sum += course.seconds * part * part;
  }
  return sum / steps;
}

TEST(FrictionCourse, TheMeanIsThatOfItsSteps) {
  const coupling::FrictionCourse course{0.05, 16.0, 11.5};
  for (const int steps : {200, 2000, 100000})
    EXPECT_NEAR(course.mean(steps) / mean_of_steps(course, steps), 1.0, 0.01) << steps;
}

TEST(FrictionCourse, WhatHasSettledStaysAsItIs) {
  EXPECT_EQ((coupling::FrictionCourse{0.05, 2000.0, 1.0}).mean(1e6), 0.05);
  EXPECT_EQ((coupling::FrictionCourse{0.05, 2000.0, 11.0}).mean(1000.0), 0.05);
}

}  // namespace
