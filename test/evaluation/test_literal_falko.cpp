// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/literal_falko.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// A corner towards the sensor at (1, 0), two points on each side of it.
LaserScan small_corner(double near) {
  return test::scan_of({1.12, near, 1.0, near, 1.12}, -0.1, 0.05);
}

Scene rectangular_room() {
  Scene room;
  room.add_box({0.0, 0.0, 0.0}, {6.0, 4.0});
  return room;
}

LaserScan noiseless_room() {
  auto random = test::seeded_random();
  LaserScan scan = test::closed_scan(rectangular_room(), test::kInTheRoom, 720, 0.0, random);
  scan.closed = false;
  return scan;
}

TEST(LiteralFalko, CountsSectorsByHand) {
  // Seen from the corner, the points of the left side lie at atan2(0.112, 0.114) = 0.774 and
  // atan2(0.051, 0.019) = 1.219 rad: sectors 1 and 3 of 16. The right side mirrors them.
  const auto keypoints = literal_falko(small_corner(1.02));
  ASSERT_EQ(keypoints.size(), 1U);
  EXPECT_EQ(keypoints[0].beam, 2U);
  EXPECT_EQ(keypoints[0].score, 4.0);
  EXPECT_NEAR(keypoints[0].radius, 0.2 * std::exp(0.07), 1e-12);
}

TEST(LiteralFalko, CountsSectorsFromTheBeam) {
  for (const double angle : {0.2, 1.0, 3.0}) {
    const auto keypoints = literal_falko(with_start_angle_turned(small_corner(1.02), angle));
    ASSERT_EQ(keypoints.size(), 1U) << angle;
    EXPECT_EQ(keypoints[0].score, 4.0) << angle;
  }
}

TEST(LiteralFalko, SidesInOneSectorEachScoreZero) {
  // The near points lie at atan2(0.053, 0.059) = 0.734 rad: sector 1, as the far ones.
  const auto keypoints = literal_falko(small_corner(1.06));
  ASSERT_EQ(keypoints.size(), 1U);
  EXPECT_EQ(keypoints[0].score, 0.0);
}

TEST(LiteralFalko, AShapeOfMirrorSymmetryPointsAlongTheBeam) {
  const auto keypoints = literal_falko(small_corner(1.06));
  ASSERT_EQ(keypoints.size(), 1U);
  EXPECT_NEAR(keypoints[0].orientation, 0.0, 1e-12);
  EXPECT_NEAR(keypoints[0].position.y(), 0.0, 1e-9);
}

TEST(LiteralFalko, NeedsTwoPointsOnEachSide) {
  LaserScan scan = small_corner(1.06);
  scan.status[1] = BeamStatus::kErroneous;
  EXPECT_TRUE(literal_falko(scan).empty());
}

TEST(LiteralFalko, FindsEveryCornerOfARoomWhereItIs) {
  const auto keypoints = literal_falko(noiseless_room());
  for (const Wall& wall : rectangular_room().walls) {
    EXPECT_TRUE(std::any_of(keypoints.begin(), keypoints.end(), [&](const Keypoint& keypoint) {
      return (test::kInTheRoom * keypoint.position - wall.from).norm() < 0.02;
    }));
  }
}

TEST(LiteralFalko, FindsNothingOnAStraightWall) {
  const LaserScan scan = noiseless_room();
  for (const Keypoint& keypoint : literal_falko(scan)) {
    const Eigen::Vector2d point = test::kInTheRoom * scan.point(keypoint.beam);
    EXPECT_LT(test::distance_to_corner(rectangular_room(), point), keypoint.radius);
  }
}

TEST(LiteralFalko, PointsIntoTheRoomFromItsCorners) {
  for (const Keypoint& keypoint : literal_falko(noiseless_room())) {
    const Eigen::Vector2d corner = test::kInTheRoom * keypoint.position;
    if (test::distance_to_corner(rectangular_room(), corner) > 0.02) continue;
    const double direction = test::kInTheRoom.theta() + keypoint.orientation;
    EXPECT_LT(std::cos(direction) * corner.x(), 0.0);
    EXPECT_LT(std::sin(direction) * corner.y(), 0.0);
  }
}

TEST(LiteralFalko, TurnsWithTheStartAngle) {
  const LaserScan scan = noiseless_room();
  const auto keypoints = literal_falko(scan);
  const auto turned = literal_falko(with_start_angle_turned(scan, 1.0));
  ASSERT_EQ(turned.size(), keypoints.size());
  for (std::size_t i = 0; i < turned.size(); ++i) {
    EXPECT_EQ(turned[i].beam, keypoints[i].beam);
    EXPECT_LT((turned[i].position - Pose2(0.0, 0.0, 1.0) * keypoints[i].position).norm(), 1e-6);
  }
}

TEST(LiteralFalko, SuppressionKeepsTheBestOfItsNeighborhood) {
  auto random = test::seeded_random();
  LaserScan scan = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 720, 0.01, random);
  LiteralFalkoParams all;
  all.suppression_radius = -1.0;
  const auto candidates = literal_falko(scan, all);
  const LiteralFalkoParams params;
  const auto kept = literal_falko(scan, params);
  const auto apart = [&](const Keypoint& a, const Keypoint& b) {
    return (scan.point(a.beam) - scan.point(b.beam)).norm();
  };
  EXPECT_GT(candidates.size(), kept.size());
  for (const Keypoint& candidate : candidates) {
    EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [&](const Keypoint& better) {
      return better.score <= candidate.score &&
             apart(better, candidate) <= params.suppression_radius;
    }));
  }
  for (std::size_t i = 1; i < kept.size(); ++i) {
    EXPECT_LT(kept[i - 1].beam, kept[i].beam);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(apart(kept[i], kept[j]), params.suppression_radius);
    }
  }
}

TEST(LiteralFalko, FindsNothingInARoundRoom) {
  EXPECT_TRUE(literal_falko(test::round_scan(4.0)).empty());
  EXPECT_TRUE(literal_falko({}).empty());
}

}  // namespace
}  // namespace falko_slam
