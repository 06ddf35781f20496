// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/odometry_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

const TricycleParams kTricycle{1.4, 2e-4, 0.01, -0.02};
const OdometryNoise kNoise{0.02, 0.01};

TEST(OdometryNoise, OfAStraightWayIsThatOfItsParts) {
  TricycleParams straight = kTricycle;
  straight.steer_offset_forward = 0.0;
  const double ticks = 5000.0;  // 1 m
  const Eigen::Matrix3d covariance = arc_covariance(straight, ticks, 0.0, kNoise);
  EXPECT_NEAR(covariance(0, 0), 0.02 * 0.02, 1e-12);
  EXPECT_NEAR(covariance(2, 2), 0.01 * 0.01 / (1.4 * 1.4), 1e-12);
  EXPECT_NEAR(covariance(0, 2), 0.0, 1e-15);
}

TEST(OdometryNoise, IsTheSameHoweverFinelyTheWayIsCut) {
  const auto driven = [](int pieces) {
    PoseEstimate sum;
    const double ticks = -30000.0 / pieces;
    for (int i = 0; i < pieces; ++i) {
      sum = compose(
          sum, {drive_arc(kTricycle, ticks, 0.4), arc_covariance(kTricycle, ticks, 0.4, kNoise)});
    }
    return sum.covariance;
  };
  const Eigen::Matrix3d coarse = driven(100), fine = driven(1000);
  EXPECT_LT((coarse - fine).norm(), 0.01 * fine.norm());
}

TEST(OdometryNoise, IsWhatRandomDrivesScatterBy) {
  constexpr int kDrives = 4000, kPieces = 20;
  const double ticks = 20000.0 / kPieces;
  const double way = kTricycle.driving_scale * ticks;
  auto random = test::seeded_random();
  PoseEstimate expected;
  for (int i = 0; i < kPieces; ++i) {
    expected = compose(expected, {drive_arc(kTricycle, ticks, 0.3),
                                  arc_covariance(kTricycle, ticks, 0.3, kNoise)});
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (int drive = 0; drive < kDrives; ++drive) {
    Pose2 pose;
    for (int i = 0; i < kPieces; ++i) {
      const double slip = test::normal(random, kNoise.slip * std::sqrt(way));
      const double steer = test::normal(random, kNoise.steer / std::sqrt(way));
      pose = pose * drive_arc(kTricycle, ticks + slip / kTricycle.driving_scale, 0.3 + steer);
    }
    const Eigen::Vector3d off(pose.x() - expected.pose.x(), pose.y() - expected.pose.y(),
                              (expected.pose.inverse() * pose).theta());
    scatter += off * off.transpose() / kDrives;
  }
  EXPECT_LT((scatter - expected.covariance).norm(), 0.08 * expected.covariance.norm());
}

TEST(OdometryNoise, OfAVehicleAtRestIsNone) {
  EXPECT_EQ(arc_covariance(kTricycle, 0.0, 0.3, kNoise), Eigen::Matrix3d::Zero());
}

TEST(OdometryNoise, IsRefusedByName) {
  EXPECT_THROW(validate(OdometryNoise{-0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(OdometryNoise{0.0, NAN}), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
