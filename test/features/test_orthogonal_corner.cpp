// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/orthogonal_corner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

TEST(OrthogonalCornerDetector, FindsTheCornersAlongTheDominantDirectionsOnly) {
  auto random = test::seeded_random();
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {6.0, 4.0});
  scene.add_box({1.6, 0.7, kPi / 4.0}, {0.6, 0.6});  // orthogonal, but in other directions
  const Pose2 pose(-0.4, 0.1, 0.2);
  OrthogonalCornerDetector detector;
  const auto keypoints = detector.detect(test::closed_scan(scene, pose, 1440, 0.005, random));
  EXPECT_EQ(keypoints.size(), 4U);
  for (const Keypoint& keypoint : keypoints) {
    const Eigen::Vector2d corner = pose * keypoint.position;
    EXPECT_NEAR(std::abs(corner.x()), 3.0, 0.02);
    EXPECT_NEAR(std::abs(corner.y()), 2.0, 0.02);
    // The bisector points to the middle of the room.
    const double to_middle = std::atan2(-corner.y() / 2.0, -corner.x() / 3.0);
    EXPECT_NEAR(angle_between(pose.theta() + keypoint.orientation, to_middle), 0.0, 0.03);
  }
}

TEST(OrthogonalCornerDetector, TurnsWithAClosedScan) {
  auto random = test::seeded_random();
  OrthogonalCornerDetector detector;
  const LaserScan scan = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 720, 0.01, random);
  const auto keypoints = detector.detect(scan);
  ASSERT_GT(keypoints.size(), 2U);
  for (const std::size_t by : {1U, 200U, 719U}) {
    auto turned = detector.detect(with_beams_rotated(scan, by));
    ASSERT_EQ(turned.size(), keypoints.size());
    for (Keypoint& keypoint : turned) keypoint.beam = (keypoint.beam + by) % scan.size();
    std::sort(turned.begin(), turned.end(),
              [](const Keypoint& a, const Keypoint& b) { return a.beam < b.beam; });
    const Pose2 back(0.0, 0.0, static_cast<double>(by) * scan.angle_increment);
    for (std::size_t i = 0; i < keypoints.size(); ++i) {
      EXPECT_EQ(turned[i].beam, keypoints[i].beam);
      EXPECT_LT((back * turned[i].position - keypoints[i].position).norm(), 1e-6);
    }
  }
}

TEST(OrthogonalCornerDetector, SurvivesDegenerateScans) {
  OrthogonalCornerDetector detector;
  EXPECT_TRUE(detector.detect(LaserScan{}).empty());
  LaserScan scan;
  scan.angle_increment = 0.1;
  for (std::size_t beams = 1; beams < 8; ++beams) {
    scan.ranges.assign(beams, 1.0);
    scan.status.assign(beams, BeamStatus::kValid);
    EXPECT_TRUE(detector.detect(scan).empty());
    scan.ranges.assign(beams, std::nan(""));
    EXPECT_TRUE(detector.detect(scan).empty());
  }
}

TEST(OrthogonalCornerParams, AreChecked) {
  OrthogonalCornerParams params;
  params.max_roughness = -1.0;
  EXPECT_THROW(OrthogonalCornerDetector detector(params), std::invalid_argument);
  params = {};
  params.spectrum.angles = 7;
  EXPECT_THROW(OrthogonalCornerDetector detector(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
