// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/falko.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// The corner of two walls, `turn` radians off straight, 2 m in front of a laser of 1080 beams over
// 180 degrees; one of the walls rises to the left of the beam to the corner.
LaserScan corner_scan(double turn, const Eigen::Vector2d& corner) {
  Scene scene;
  const double outwards = std::atan2(corner.y(), corner.x());
  for (const double side : {1.0, -1.0}) {
    const double direction = outwards + side * (kPi / 2.0 + 0.5 * turn);
    scene.walls.push_back(
        {corner, corner + 5.0 * Eigen::Vector2d(std::cos(direction), std::sin(direction))});
  }
  LaserScan scan;
  scan.angle_min = -kPi / 2.0;
  scan.angle_increment = kPi / 1080.0;
  for (int i = 0; i < 1081; ++i) {
    const double range = scene.cast({0.0, 0.0, scan.angle_min + i * scan.angle_increment});
    const bool valid = range < 30.0;
    scan.ranges.push_back(valid ? range : std::nan(""));
    scan.status.push_back(valid ? BeamStatus::kValid : BeamStatus::kTooFar);
  }
  return scan;
}

bool same_keypoint(const Keypoint& a, const Keypoint& b) {
  return a.beam == b.beam && a.position == b.position && a.orientation == b.orientation &&
         a.score == b.score && a.roughness == b.roughness && a.radius == b.radius;
}

TEST(FalkoDetector, FindsTheCornersOfARoom) {
  auto random = test::seeded_random();
  const Scene room = test::room_with_pillar();
  FalkoDetector detector;
  const auto keypoints =
      detector.detect(test::closed_scan(room, test::kInTheRoom, 1440, 0.005, random));
  // Four corners of the room and the one of the pillar of which both sides are in sight.
  EXPECT_EQ(keypoints.size(), 5U);
  for (const Keypoint& keypoint : keypoints) {
    EXPECT_LT(test::distance_to_corner(room, test::kInTheRoom * keypoint.position), 0.03);
  }
}

// Beams are 6 mm apart at the corner; averaging ranges over a window rounds it by about as much.
TEST(FalkoDetector, FindsACornerBetweenBeams) {
  FalkoDetector detector;
  for (const double turn : {1.0, kPi / 2.0, -kPi / 2.0, 2.0}) {
    const Eigen::Vector2d corner(2.0, 0.0013);
    const auto keypoints = detector.detect(corner_scan(turn, corner));
    ASSERT_EQ(keypoints.size(), 1U) << turn;
    EXPECT_LT((keypoints[0].position - corner).norm(), 0.01) << turn;
  }
}

TEST(FalkoDetector, OrientationPointsIntoTheCorner) {
  FalkoDetector detector;
  // A corner that points away from the sensor opens towards it, and the other way round.
  const auto away = detector.detect(corner_scan(kPi / 2.0, {2.0, 0.0}));
  const auto towards = detector.detect(corner_scan(-kPi / 2.0, {2.0, 0.0}));
  ASSERT_EQ(away.size(), 1U);
  ASSERT_EQ(towards.size(), 1U);
  EXPECT_NEAR(std::abs(away[0].orientation), kPi, 0.05);
  EXPECT_NEAR(towards[0].orientation, 0.0, 0.05);
}

TEST(FalkoDetector, IgnoresAStraightWall) {
  FalkoDetector detector;
  EXPECT_TRUE(detector.detect(corner_scan(0.0, {2.0, 0.0})).empty());
  EXPECT_TRUE(detector.detect(corner_scan(0.3, {2.0, 0.0})).empty());  // below 2 asin(1 / beta)
}

// Turning the ranges of a closed scan by k beams turns the keypoints with them, to the bit.
TEST(FalkoDetector, TurnsWithAClosedScan) {
  auto random = test::seeded_random();
  const Scene scene = office_scene();
  FalkoDetector detector;
  for (const std::size_t beams : {360U, 1440U}) {
    for (const double noise : {0.0, 0.01, 0.05}) {
      const LaserScan scan = test::closed_scan(scene, {-3.0, -1.0, 0.4}, beams, noise, random);
      const auto keypoints = detector.detect(scan);
      ASSERT_GT(keypoints.size(), 2U);
      for (const std::size_t by : {std::size_t{1}, beams / 3, beams / 2, beams - 1}) {
        auto turned = detector.detect(with_beams_rotated(scan, by));
        ASSERT_EQ(turned.size(), keypoints.size()) << beams << " " << noise << " " << by;
        for (Keypoint& keypoint : turned) keypoint.beam = (keypoint.beam + by) % beams;
        std::sort(turned.begin(), turned.end(),
                  [](const Keypoint& a, const Keypoint& b) { return a.beam < b.beam; });
        const Pose2 back(0.0, 0.0, static_cast<double>(by) * scan.angle_increment);
        for (std::size_t i = 0; i < keypoints.size(); ++i) {
          EXPECT_EQ(turned[i].beam, keypoints[i].beam);
          EXPECT_EQ(turned[i].score, keypoints[i].score);
          EXPECT_EQ(turned[i].roughness, keypoints[i].roughness);
          EXPECT_EQ(turned[i].radius, keypoints[i].radius);
          EXPECT_LT((back * turned[i].position - keypoints[i].position).norm(), 1e-9);
          EXPECT_NEAR(angle_between(turned[i].orientation + back.theta(), keypoints[i].orientation),
                      0.0, 1e-9);
        }
      }
    }
  }
}

// A corner that lies on the seam is found like any other.
TEST(FalkoDetector, NeighborhoodsReachOverTheSeam) {
  auto random = test::seeded_random();
  Scene room;
  room.add_box({0.0, 0.0, 0.0}, {6.0, 4.0});
  const double to_corner = std::atan2(2.0, 3.0);
  // Bearing pi, where beams end and begin, points at the corner (3, 2).
  const Pose2 pose(0.0, 0.0, to_corner - kPi);
  FalkoDetector detector;
  LaserScan scan = test::closed_scan(room, pose, 720, 0.0, random);
  EXPECT_EQ(detector.detect(scan).size(), 4U);
  scan.closed = false;
  EXPECT_EQ(detector.detect(scan).size(), 3U);
}

TEST(FalkoDetector, AMirroredScanHasTheMirroredKeypoints) {
  auto random = test::seeded_random();
  FalkoDetector detector;
  LaserScan scan = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 1440, 0.01, random);
  const auto keypoints = detector.detect(scan);
  LaserScan mirrored = scan;
  std::reverse(mirrored.ranges.begin(), mirrored.ranges.end());
  std::reverse(mirrored.status.begin(), mirrored.status.end());
  mirrored.angle_min = -scan.bearing(scan.size() - 1);

  auto reflected = detector.detect(mirrored);

  ASSERT_EQ(reflected.size(), keypoints.size());
  std::reverse(reflected.begin(), reflected.end());
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    EXPECT_NEAR(reflected[i].position.x(), keypoints[i].position.x(), 1e-5);
    EXPECT_NEAR(reflected[i].position.y(), -keypoints[i].position.y(), 1e-5);
    EXPECT_NEAR(angle_between(reflected[i].orientation, -keypoints[i].orientation), 0.0, 1e-4);
  }
}

// Five invalid beams change nothing away from them.
TEST(FalkoDetector, InvalidBeamsActLocallyOnly) {
  auto random = test::seeded_random();
  FalkoDetector detector;
  const LaserScan scan = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 1440, 0.01, random);
  const auto keypoints = detector.detect(scan);
  for (int run = 0; run < 20; ++run) {
    LaserScan damaged = scan;
    std::vector<std::size_t> lost;
    for (int i = 0; i < 5; ++i) {
      lost.push_back(std::uniform_int_distribution<std::size_t>(0, scan.size() - 1)(random));
      damaged.ranges[lost.back()] = std::nan("");
      damaged.status[lost.back()] = BeamStatus::kErroneous;
    }
    const auto remaining = detector.detect(damaged);
    for (const Keypoint& keypoint : keypoints) {
      // Neighbourhood of the corner, of those that are merged with it, and of those it suppresses.
      const double reach = 3.0 * keypoint.radius;
      const bool touched = std::any_of(lost.begin(), lost.end(), [&](std::size_t beam) {
        return (scan.point(beam) - keypoint.position).norm() < reach;
      });
      if (touched) continue;
      EXPECT_TRUE(std::any_of(remaining.begin(), remaining.end(), [&](const Keypoint& other) {
        return same_keypoint(other, keypoint);
      }));
    }
  }
}

TEST(FalkoDetector, TheSameScanGivesTheSameKeypointsAfterOthers) {
  auto random = test::seeded_random();
  FalkoDetector detector;
  const LaserScan scan = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 1440, 0.01, random);
  const LaserScan other = test::closed_scan(office_scene(), {3.0, 1.0, 1.4}, 360, 0.02, random);
  const auto first = detector.detect(scan);
  detector.detect(other);
  const auto second = detector.detect(scan);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(same_keypoint(first[i], second[i]));
}

TEST(FalkoDetector, KeepsKeypointsApart) {
  auto random = test::seeded_random();
  FalkoParams params;
  params.merge_radius = 0.0;
  FalkoDetector detector(params);
  const auto keypoints =
      detector.detect(test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 1440, 0.03, random));
  ASSERT_GT(keypoints.size(), 5U);
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((keypoints[i].position - keypoints[j].position).norm(), params.suppression_radius);
    }
  }
}

TEST(FalkoDetector, SurvivesDegenerateScans) {
  FalkoDetector detector;
  EXPECT_TRUE(detector.detect(LaserScan{}).empty());
  for (const std::size_t beams : {1U, 2U, 3U, 5U, 100000U}) {
    for (const double range : {std::nan(""), 1e-6, 0.05, 3.0, 1e5}) {
      for (const bool closed : {false, true}) {
        LaserScan scan;
        scan.angle_min = -kPi;
        scan.angle_increment = kTwoPi / static_cast<double>(beams);
        scan.closed = closed;
        scan.ranges.assign(beams, range);
        scan.status.assign(beams, std::isnan(range) ? BeamStatus::kErroneous : BeamStatus::kValid);
        for (const Keypoint& keypoint : detector.detect(scan)) {
          EXPECT_TRUE(keypoint.position.allFinite()) << beams << " " << range;
        }
      }
    }
  }
}

TEST(FalkoDetector, ACircularWallHasNoCorner) {
  FalkoDetector detector;
  LaserScan scan;
  scan.angle_min = -kPi;
  scan.angle_increment = kTwoPi / 1440.0;
  scan.closed = true;
  scan.ranges.assign(1440, 3.0);
  scan.status.assign(1440, BeamStatus::kValid);
  EXPECT_TRUE(detector.detect(scan).empty());
}

TEST(FalkoParams, NamesFieldAndValueOfWhatIsWrong) {
  FalkoParams params;
  params.triangle_ratio = -2.0;
  try {
    FalkoDetector detector(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("triangle_ratio = -2"), std::string::npos)
        << error.what();
  }
}

TEST(FalkoParams, RefusesWhatIsOutOfRangeOrNaN) {
  const double nan = std::nan("");
  const auto refuses = [](auto&& change) {
    FalkoParams params;
    change(params);
    EXPECT_THROW(FalkoDetector detector(params), std::invalid_argument);
  };
  refuses([&](FalkoParams& p) { p.neighborhood.radius_scale = nan; });
  refuses([&](FalkoParams& p) { p.neighborhood.radius_growth = -0.1; });
  refuses([&](FalkoParams& p) { p.neighborhood.max_radius = 0.1; });
  refuses([&](FalkoParams& p) { p.neighborhood.sample_spacing = 0.6; });
  refuses([&](FalkoParams& p) { p.neighborhood.smoothing_window = nan; });
  refuses([&](FalkoParams& p) { p.neighborhood.min_incidence = 2.0; });
  refuses([&](FalkoParams& p) { p.neighborhood.min_points_per_side = 1; });
  refuses([&](FalkoParams& p) { p.sectors = 1; });
  refuses([&](FalkoParams& p) { p.suppression_radius = -1.0; });
  refuses([&](FalkoParams& p) { p.refinement_limit = nan; });
  refuses([&](FalkoParams& p) { p.merge_radius = 0.15; });
}

}  // namespace
}  // namespace falko_slam
