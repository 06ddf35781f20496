// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/odometry_track.hpp"

#include <gtest/gtest.h>

#include "support/times.hpp"

namespace falko_slam {
namespace {

const PoseEstimate kMotion{{0.1, 0.0, 0.02}, pose_covariance(0.01, 0.002)};

// Ten motions of 0.1 s from 100 s on.
OdometryTrack ten_motions() {
  OdometryTrack track(std::chrono::seconds(2));
  for (int i = 0; i <= 10; ++i) track.add(test::at_seconds(100.0 + 0.1 * i), kMotion);
  return track;
}

Pose2 after(double motions) { return Pose2::exp(motions * kMotion.pose.log()); }

void expect_near(const Pose2& pose, const Pose2& expected) {
  EXPECT_LT((pose.inverse() * expected).log().norm(), 1e-9);
}

TEST(OdometryTrack, MovesWithConstantVelocityBetweenMotions) {
  const OdometryTrack track = ten_motions();
  expect_near(track.at(test::at_seconds(100.0)), {});
  expect_near(track.at(test::at_seconds(100.25)), after(2.5));
  expect_near(track.at(test::at_seconds(99.0)), {});
  expect_near(track.at(test::at_seconds(101.1)), after(11.0));
  expect_near(track.at(test::at_seconds(105.0)), after(12.0));
}

TEST(OdometryTrack, SumsUpMotionAndCovarianceBetweenTwoTimes) {
  const PoseEstimate way =
      ten_motions().between(test::at_seconds(100.25), test::at_seconds(100.75));
  expect_near(way.pose, after(5.0));
  EXPECT_GT(way.covariance(0, 0), 3.5 * 1e-4);
  EXPECT_LT(way.covariance(0, 0), 5.5 * 1e-4);
}

TEST(OdometryTrack, PutsALateMotionInItsPlace) {
  OdometryTrack track(std::chrono::seconds(2));
  for (const double seconds : {100.0, 100.2, 100.3, 100.1})
    track.add(test::at_seconds(seconds), kMotion);
  track.add(test::at_seconds(100.2), {{5.0, 5.0, 1.0}, {}});
  track.add(test::at_seconds(99.0), {{5.0, 5.0, 1.0}, {}});
  expect_near(track.at(test::at_seconds(100.3)), after(3.0));
  EXPECT_EQ(track.since(test::at_seconds(100.15)).size(), 2U);
}

TEST(OdometryTrack, RemembersSoMuchAndNoMore) {
  OdometryTrack track(std::chrono::seconds(2));
  EXPECT_TRUE(track.empty());
  for (int i = 0; i <= 100; ++i) track.add(test::at_seconds(0.1 * i), kMotion);
  EXPECT_LE(track.end() - track.begin(), from_seconds(2.11));
  expect_near(track.at(track.end()), after(100.0));
  track.clear();
  EXPECT_TRUE(track.empty());
}

}  // namespace
}  // namespace falko_slam
