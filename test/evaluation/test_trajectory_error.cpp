// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/trajectory_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using test::at_seconds;

// A circle of 2 m, 10 cm and 0.1 s from pose to pose.
Trajectory circle() {
  Trajectory trajectory;
  for (int i = 0; i < 120; ++i) {
    trajectory.push_back({at_seconds(0.1 * i), Pose2::exp({0.1 * i, 0.0, 0.05 * i})});
  }
  return trajectory;
}

TEST(TrajectoryError, IsZeroForTheTruthInAnotherFrame) {
  Trajectory estimated = circle();
  const Pose2 elsewhere(5.0, -3.0, 2.0);
  for (StampedPose& pose : estimated) pose.map_T_base = elsewhere * pose.map_T_base;
  const auto errors = evaluate_trajectory(estimated, circle());
  EXPECT_LT(summarise(errors.absolute.translation).max, 1e-9);
  EXPECT_LT(summarise(errors.absolute.rotation).max, 1e-9);
  EXPECT_LT(summarise(errors.relative.translation).max, 1e-9);
  EXPECT_LT((errors.truth_T_map * elsewhere).translation().norm(), 1e-9);
  EXPECT_EQ(errors.missing, 0U);
}

TEST(TrajectoryError, InterpolatesTheTruthBetweenItsStamps) {
  Trajectory truth;
  for (std::size_t i = 0; i < 120; i += 4) truth.push_back(circle()[i]);
  const auto errors = evaluate_trajectory(circle(), truth);
  EXPECT_LT(summarise(errors.absolute.translation).max, 1e-9);
  EXPECT_EQ(errors.missing, 3U);  // behind the last true one
  TrajectoryErrorParams params;
  params.max_gap = 0.3;
  EXPECT_EQ(evaluate_trajectory(circle(), truth, params).missing, 90U);
}

// Two points 2 m apart where there should be 4: each ends 1 m from where it belongs.
TEST(TrajectoryError, IsWhatAHandComputes) {
  const Trajectory truth = {{at_seconds(0.0), {0.0, 0.0, 0.0}}, {at_seconds(1.0), {4.0, 0.0, 0.0}}};
  const Trajectory estimated = {{at_seconds(0.0), {0.0, 1.0, 0.5 * kPi}},
                                {at_seconds(1.0), {0.0, 3.0, 0.5 * kPi + 0.1}}};
  const auto errors = evaluate_trajectory(estimated, truth);
  ASSERT_EQ(errors.absolute.translation.size(), 2U);
  EXPECT_NEAR(errors.absolute.translation[0], 1.0, 1e-9);
  EXPECT_NEAR(errors.absolute.translation[1], 1.0, 1e-9);
  EXPECT_NEAR(errors.absolute.rotation[0], 0.0, 1e-9);
  EXPECT_NEAR(errors.absolute.rotation[1], 0.1, 1e-9);
  ASSERT_EQ(errors.relative.translation.size(), 1U);
  EXPECT_NEAR(errors.relative.translation[0], 2.0, 1e-9);
  EXPECT_NEAR(errors.relative.rotation[0], 0.1, 1e-9);
}

TEST(TrajectoryError, RelativeErrorsAreThoseOfMotionsOverTheDistance) {
  Trajectory estimated = circle();
  for (std::size_t i = 0; i < estimated.size(); ++i) {
    estimated[i].map_T_base =
        Pose2::exp({0.1 * static_cast<double>(i), 0.0, 0.051 * static_cast<double>(i)});
  }
  TrajectoryErrorParams params;
  params.distance = 1.99;  // twenty steps, each a chord of 0.09999 m
  const auto errors = evaluate_trajectory(estimated, circle(), params);
  EXPECT_EQ(errors.relative.rotation.size(), 100U);
  for (const double rotation : errors.relative.rotation) EXPECT_NEAR(rotation, 0.02, 1e-9);
}

TEST(TrajectoryError, NeedsPosesInCommon) {
  EXPECT_THROW(evaluate_trajectory({}, circle()), std::runtime_error);
  EXPECT_THROW(evaluate_trajectory(circle(), {}), std::runtime_error);
  const Trajectory still(10, {at_seconds(1.0), {1.0, 2.0, 0.0}});
  EXPECT_THROW(evaluate_trajectory(still, circle()), std::runtime_error);
  TrajectoryErrorParams params;
  params.distance = std::nan("");
  EXPECT_THROW(evaluate_trajectory(circle(), circle(), params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
