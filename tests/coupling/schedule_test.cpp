#include "coupling/schedule.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace shmoo;

TEST(Schedule, RecordsComeOnceAndInOrder) {
  scene::Run run;
  run.until = 1.0;
  run.record_every = 0.25;
  run.record_at = {0.1, 0.5, 0.9999999999999};
  const auto times = coupling::record_times(run);
  EXPECT_EQ(times, (std::vector<double>{0.0, 0.1, 0.25, 0.5, 0.75, 1.0}));
}

TEST(Schedule, TheLastRecordIsTheEndEvenWhereTheIntervalDoesNotDivideIt) {
  scene::Run run;
  run.until = 1.0;
  run.record_every = 0.3;
  const auto times = coupling::record_times(run);
  EXPECT_EQ(times.size(), 5u);
  EXPECT_EQ(times.back(), 1.0);
}

TEST(Schedule, IntervalsLeaveNoSliver) {
  double t = 0.0;
  int intervals = 0;
  while (t < 1.0) {
    const double end = coupling::interval_end(t, 0.3, 1.0);
    EXPECT_LE(end - t, 0.3 * (1.0 + 1e-9));
    EXPECT_GE(end - t, 0.2);
    t = end;
    ++intervals;
  }
  EXPECT_EQ(t, 1.0);
  EXPECT_EQ(intervals, 4);
  EXPECT_EQ(coupling::interval_end(0.0, std::numeric_limits<double>::infinity(), 2.0), 2.0);
}

}  // namespace
