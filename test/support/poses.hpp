// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {
namespace test {

/// Of each coordinate, the angle the shorter way round.
inline void expect_near(const Pose2& pose, const Pose2& expected, double tolerance) {
  EXPECT_NEAR(pose.x(), expected.x(), tolerance) << pose << " instead of " << expected;
  EXPECT_NEAR(pose.y(), expected.y(), tolerance) << pose << " instead of " << expected;
  EXPECT_NEAR(angle_between(pose.theta(), expected.theta()), 0.0, tolerance)
      << pose << " instead of " << expected;
}

}  // namespace test
}  // namespace falko_slam
