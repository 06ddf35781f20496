// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "support/scene.hpp"

namespace falko_slam {
namespace {

constexpr double kStep = 0.1;

double distance_to_wall(const Wall& wall, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = wall.to - wall.from;
  const double share = (point - wall.from).dot(along) / along.squaredNorm();
  return (wall.from + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

TEST(OfficePath, StaysClearOfTheWalls) {
  const Scene scene = office_scene();
  for (const Pose2& pose : office_path(kStep)) {
    for (const Wall& wall : scene.walls) {
      EXPECT_GT(distance_to_wall(wall, pose.translation()), 0.3) << pose;
    }
  }
}

TEST(OfficePath, GoesInSteps) {
  const auto path = office_path(kStep);
  ASSERT_GT(path.size(), 100U);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d step = path[i].translation() - path[i - 1].translation();
    EXPECT_LE(step.norm(), kStep + 1e-9);
    // On the half circles of radius 1 a step is the chord of its arc.
    EXPECT_GE(step.norm(), 2.0 * std::sin(0.5 * kStep) - 1e-9);
  }
}

TEST(OfficePath, HeadsWhereItGoes) {
  const auto path = office_path(kStep);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d step = path[i].translation() - path[i - 1].translation();
    const double direction = std::atan2(step.y(), step.x());
    // Half the turn of a step on the half circles.
    EXPECT_LE(std::abs(angle_between(path[i - 1].theta(), direction)), 0.5 * kStep + 1e-9);
    EXPECT_LE(std::abs(angle_between(direction, path[i].theta())), 0.5 * kStep + 1e-9);
  }
}

TEST(OfficePath, ClosesOnItself) {
  const auto path = office_path(kStep);
  const Pose2 gap = path.back().inverse() * path.front();
  EXPECT_LE(gap.translation().norm(), kStep + 1e-9);
  EXPECT_LE(std::abs(gap.theta()), kStep + 1e-9);
}

TEST(OfficePath, RefusesStepsThatNeverArrive) {
  EXPECT_THROW(office_path(0.0), std::invalid_argument);
  EXPECT_THROW(office_path(-1.0), std::invalid_argument);
  EXPECT_THROW(office_path(std::nan("")), std::invalid_argument);
}

TEST(OfficeScene, IsClosedAllAround) {
  const Scene scene = office_scene();
  for (const Pose2& pose : office_path(2.0)) {
    for (double angle = -kPi; angle < kPi; angle += 0.05) {
      EXPECT_LT(scene.cast(pose * Pose2(0.0, 0.0, angle)), std::hypot(24.0, 16.0));
    }
  }
}

}  // namespace
}  // namespace falko_slam
