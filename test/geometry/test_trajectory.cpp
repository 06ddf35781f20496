// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/trajectory.hpp"

#include <gtest/gtest.h>

#include "falko_slam/geometry/angles.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using test::at_seconds;

TEST(TrajectoryIndex, FindsPosesWhateverTheirOrder) {
  const TrajectoryIndex index({{at_seconds(3.0), {3.0, 0.0, 0.0}},
                               {at_seconds(1.0), {1.0, 0.0, 0.0}},
                               {at_seconds(2.0), {2.0, 0.0, 0.0}}});
  for (const double t : {1.0, 2.0, 3.0}) EXPECT_EQ(index.at(at_seconds(t))->x(), t);
  for (const double t : {0.0, 1.5, 4.0}) EXPECT_FALSE(index.at(at_seconds(t))) << t;
}

TEST(TrajectoryIndex, TakesTheFirstOfTheSameStamp) {
  const TrajectoryIndex index({{at_seconds(2.0), {2.0, 0.0, 0.0}},
                               {at_seconds(1.0), {5.0, 0.0, 0.0}},
                               {at_seconds(2.0), {7.0, 0.0, 0.0}}});
  EXPECT_EQ(index.at(at_seconds(2.0))->x(), 2.0);
}

TEST(TrajectoryIndex, ComparesWholeMicroseconds) {
  const TrajectoryIndex index({{Time(Duration(976052890235301017)), {1.0, 0.0, 0.0}}});
  EXPECT_TRUE(index.at(Time(Duration(976052890235301000))));
  EXPECT_TRUE(index.at(Time(Duration(976052890235300600))));
  EXPECT_FALSE(index.at(Time(Duration(976052890235302000))));
}

TEST(TrajectoryIndex, InterpolatesAlongTheArc) {
  const TrajectoryIndex index(
      {{at_seconds(0.0), {0.0, 0.0, 0.0}}, {at_seconds(2.0), {2.0, 2.0, 0.5 * kPi}}});
  const Pose2 middle = *index.interpolate(at_seconds(1.0), from_seconds(2.0));
  EXPECT_NEAR(middle.x(), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(middle.y(), 2.0 - std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(middle.theta(), 0.25 * kPi, 1e-12);
  EXPECT_EQ(index.interpolate(at_seconds(2.0), from_seconds(0.0))->x(), 2.0);
}

TEST(TrajectoryIndex, DoesNotInterpolateAcrossGapsOrBeyondTheEnds) {
  const TrajectoryIndex index({{at_seconds(0.0), {}}, {at_seconds(2.0), {}}});
  EXPECT_FALSE(index.interpolate(at_seconds(1.0), from_seconds(1.9)));
  EXPECT_FALSE(index.interpolate(at_seconds(-0.1), from_seconds(9.0)));
  EXPECT_FALSE(index.interpolate(at_seconds(2.1), from_seconds(9.0)));
  EXPECT_FALSE(TrajectoryIndex({}).interpolate(at_seconds(0.0), from_seconds(9.0)));
}

}  // namespace
}  // namespace falko_slam
