// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/flirt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

const Pose2 kInTheOffice(-3.0, -1.0, 0.4);

// What a laser of 720 beams over 180 degrees sees of the walls.
LaserScan half_scan(const Scene& scene) {
  std::vector<double> ranges;
  for (int i = 0; i < 720; ++i) {
    const double range = scene.cast({0.0, 0.0, -kPi / 2.0 + i * kPi / 720.0});
    ranges.push_back(range < 30.0 ? range : test::kNoRange);
  }
  return test::scan_of(ranges, -kPi / 2.0, kPi / 720.0);
}

bool has_keypoint_at(const std::vector<Keypoint>& keypoints, const Eigen::Vector2d& point,
                     double tolerance) {
  return std::any_of(keypoints.begin(), keypoints.end(), [&](const Keypoint& keypoint) {
    return (keypoint.position - point).norm() < tolerance;
  });
}

// Both signals.
class Flirt : public ::testing::TestWithParam<FlirtParams::Signal> {
 protected:
  Flirt()
      : params_(GetParam() == FlirtParams::Signal::kRange ? flirt_range_params() : FlirtParams{}),
        detector_(params_) {}

  FlirtParams params_;
  FlirtDetector detector_;
};
INSTANTIATE_TEST_SUITE_P(Signals, Flirt,
                         ::testing::Values(FlirtParams::Signal::kCurvature,
                                           FlirtParams::Signal::kRange),
                         [](const auto& signal) {
                           return signal.param == FlirtParams::Signal::kRange ? "Range"
                                                                              : "Curvature";
                         });

// Turning the ranges of a closed scan by k beams turns the keypoints with them, to the bit in all
// that has no direction.
TEST_P(Flirt, TurnsWithAClosedScan) {
  auto random = test::seeded_random();
  for (const Scene& scene : {office_scene(), test::room_with_pillar()}) {
    for (const double noise : {0.0, 0.01, 0.05}) {
      const LaserScan scan = test::closed_scan(scene, test::kInTheRoom, 720, noise, random);
      const auto keypoints = detector_.detect(scan);
      ASSERT_GT(keypoints.size(), 0U);
      for (const std::size_t by : {1U, 240U, 360U, 719U}) {
        auto turned = detector_.detect(with_beams_rotated(scan, by));
        ASSERT_EQ(turned.size(), keypoints.size()) << noise << " " << by;
        for (Keypoint& keypoint : turned) keypoint.beam = (keypoint.beam + by) % 720;
        std::sort(turned.begin(), turned.end(),
                  [](const Keypoint& a, const Keypoint& b) { return a.beam < b.beam; });
        const Pose2 back(0.0, 0.0, static_cast<double>(by) * scan.angle_increment);
        for (std::size_t i = 0; i < keypoints.size(); ++i) {
          EXPECT_EQ(turned[i].beam, keypoints[i].beam);
          EXPECT_EQ(turned[i].score, keypoints[i].score);
          EXPECT_EQ(turned[i].radius, keypoints[i].radius);
          EXPECT_LT((back * turned[i].position - keypoints[i].position).norm(), 1e-9);
          EXPECT_NEAR(angle_between(turned[i].orientation + back.theta(), keypoints[i].orientation),
                      0.0, 1e-9);
        }
      }
    }
  }
}

// Invalid beams change nothing farther away than the coarsest scale reaches.
TEST_P(Flirt, InvalidBeamsActLocallyOnly) {
  auto random = test::seeded_random();
  const LaserScan scan = test::closed_scan(office_scene(), kInTheOffice, 1440, 0.01, random);
  const auto keypoints = detector_.detect(scan);
  std::size_t compared = 0;
  for (const BeamStatus status : {BeamStatus::kErroneous, BeamStatus::kZero}) {
    for (int run = 0; run < 10; ++run) {
      LaserScan damaged = scan;
      const auto lost = std::uniform_int_distribution<std::size_t>(0, scan.size() - 1)(random);
      damaged.ranges[lost] = test::kNoRange;
      damaged.status[lost] = status;
      const auto remaining = detector_.detect(damaged);
      for (const Keypoint& keypoint : keypoints) {
        if ((scan.point(lost) - keypoint.position).norm() < 3.0) continue;
        const double apart =
            std::abs(angle_between(scan.bearing(lost), scan.bearing(keypoint.beam)));
        if (apart < 0.2) continue;
        EXPECT_TRUE(has_keypoint_at(remaining, keypoint.position, 1e-9)) << lost;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 40U);
}

TEST_P(Flirt, TheSameScanGivesTheSameKeypointsAfterOthers) {
  auto random = test::seeded_random();
  const LaserScan scan = test::closed_scan(office_scene(), kInTheOffice, 1440, 0.01, random);
  const LaserScan other = test::closed_scan(office_scene(), {3.0, 1.0, 1.4}, 360, 0.02, random);
  const auto first = detector_.detect(scan);
  detector_.detect(other);
  const auto second = detector_.detect(scan);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].position, second[i].position);
    EXPECT_EQ(first[i].orientation, second[i].orientation);
    EXPECT_EQ(first[i].score, second[i].score);
  }
}

TEST_P(Flirt, KeepsKeypointsApartInMetres) {
  auto random = test::seeded_random();
  const auto keypoints =
      detector_.detect(test::closed_scan(office_scene(), kInTheOffice, 1440, 0.05, random));
  ASSERT_GT(keypoints.size(), 5U);
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((keypoints[i].position - keypoints[j].position).norm(), params_.suppression_radius);
    }
  }
}

TEST_P(Flirt, SurvivesDegenerateScans) {
  EXPECT_TRUE(detector_.detect(LaserScan{}).empty());
  for (const std::size_t beams : {1U, 2U, 3U, 4U, 5U, 7U, 5000U}) {
    for (const double range : {test::kNoRange, 1e-6, 0.05, 3.0, 1e5}) {
      for (const bool closed : {false, true}) {
        LaserScan scan = test::circle_of(std::vector<double>(beams, range));
        scan.closed = closed;
        for (const Keypoint& keypoint : detector_.detect(scan)) {
          EXPECT_TRUE(keypoint.position.allFinite()) << beams << " " << range;
          EXPECT_TRUE(std::isfinite(keypoint.orientation)) << beams << " " << range;
        }
        if (beams < 4 || std::isnan(range)) {
          EXPECT_TRUE(detector_.detect(scan).empty()) << beams << " " << range;
        }
      }
    }
  }
}

TEST_P(Flirt, FewValidBeamsAmongManyAreNoKeypoints) {
  for (const std::size_t valid : {1U, 2U, 3U}) {
    std::vector<double> ranges(360, test::kNoRange);
    for (std::size_t i = 0; i < valid; ++i) ranges[100 + i] = 2.0;
    EXPECT_TRUE(detector_.detect(test::circle_of(ranges)).empty()) << valid;
  }
}

TEST_P(Flirt, ThousandsOfBeamsAreNoMatter) {
  auto random = test::seeded_random();
  const Scene room = test::room_with_pillar();
  const auto keypoints =
      detector_.detect(test::closed_scan(room, test::kInTheRoom, 5000, 0.005, random));
  ASSERT_FALSE(keypoints.empty());
  for (const Keypoint& keypoint : keypoints) EXPECT_TRUE(keypoint.position.allFinite());
}

TEST_P(Flirt, ARoundWallHasNoKeypoint) {
  EXPECT_TRUE(detector_.detect(test::round_scan(3.0, 1440)).empty());
}

TEST(FlirtCurvature, FindsTheCornersOfARoom) {
  auto random = test::seeded_random();
  const Scene room = test::room_with_pillar();
  FlirtDetector detector;
  const auto keypoints =
      detector.detect(test::closed_scan(room, test::kInTheRoom, 1440, 0.005, random));
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(3.0, 2.0), Eigen::Vector2d(-3.0, 2.0),
                                        Eigen::Vector2d(-3.0, -2.0), Eigen::Vector2d(3.0, -2.0)}) {
    EXPECT_TRUE(has_keypoint_at(keypoints, test::kInTheRoom.inverse() * corner, 0.05))
        << corner.transpose();
  }
}

// t = 2 E|s| cos(half the angle) / sigma with E|s| = sqrt(2 / pi) sigma: 1.13 at a right angle,
// whatever the scale.
TEST(FlirtCurvature, TheResponseTellsTheAngle) {
  FlirtParams params;
  params.noise_window = 0.0;
  params.edges = false;
  FlirtDetector detector(params);
  for (const double angle : {kPi / 2.0, 2.0, 2.4}) {
    Scene scene;
    for (const double side : {1.0, -1.0}) {
      const double direction = kPi + side * 0.5 * angle;
      scene.walls.push_back({{4.0, 0.0},
                             Eigen::Vector2d(4.0, 0.0) +
                                 6.0 * Eigen::Vector2d(std::cos(direction), std::sin(direction))});
    }
    const auto keypoints = detector.detect(half_scan(scene));
    ASSERT_EQ(keypoints.size(), 1U) << angle;
    const double expected = 2.0 * std::sqrt(2.0 / kPi) * std::cos(0.5 * angle);
    EXPECT_NEAR(1.0 / keypoints[0].score, expected, 0.03 * expected) << angle;
    EXPECT_LT((keypoints[0].position - Eigen::Vector2d(4.0, 0.0)).norm(), 0.02) << angle;
    EXPECT_NEAR(std::abs(keypoints[0].orientation), kPi, 0.05) << angle;
  }
}

TEST(FlirtCurvature, AFlatWallHasNoKeypoint) {
  Scene scene;
  scene.walls.push_back({{2.0, -8.0}, {2.0, 8.0}});
  EXPECT_TRUE(FlirtDetector().detect(half_scan(scene)).empty());
}

// A screen 2 m ahead before a wall 3 m behind it.
Scene screen_before_a_wall() {
  Scene scene;
  scene.walls.push_back({{2.0, -0.5}, {2.0, 0.5}});
  scene.walls.push_back({{5.0, -8.0}, {5.0, 8.0}});
  return scene;
}

TEST(FlirtCurvature, EndsOfTheNearerSurfaceAreKeypointsIfAskedFor) {
  const LaserScan scan = half_scan(screen_before_a_wall());
  const auto keypoints = FlirtDetector().detect(scan);
  ASSERT_EQ(keypoints.size(), 2U);
  EXPECT_LT((keypoints[0].position - Eigen::Vector2d(2.0, -0.5)).norm(), 0.02);
  EXPECT_LT((keypoints[1].position - Eigen::Vector2d(2.0, 0.5)).norm(), 0.02);
  EXPECT_NEAR(keypoints[0].orientation, kPi / 2.0, 0.05);  // into the screen
  EXPECT_NEAR(keypoints[1].orientation, -kPi / 2.0, 0.05);
  FlirtParams params;
  params.edges = false;
  EXPECT_TRUE(FlirtDetector(params).detect(scan).empty());
}

TEST(FlirtRange, FindsTheNearerSideOfAJump) {
  const auto keypoints =
      FlirtDetector(flirt_range_params()).detect(half_scan(screen_before_a_wall()));
  ASSERT_EQ(keypoints.size(), 2U);
  EXPECT_LT((keypoints[0].position - Eigen::Vector2d(2.0, -0.5)).norm(), 0.02);
  EXPECT_LT((keypoints[1].position - Eigen::Vector2d(2.0, 0.5)).norm(), 0.02);
  for (const Keypoint& keypoint : keypoints) {  // the normal, towards the laser
    EXPECT_NEAR(std::abs(keypoint.orientation), kPi, 0.05);
  }
}

TEST(FlirtParams, NamesFieldAndValueOfWhatIsWrong) {
  FlirtParams params;
  params.sigma_step = 0.5;
  try {
    FlirtDetector detector(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("sigma_step = 0.5"), std::string::npos)
        << error.what();
  }
}

TEST(FlirtParams, RefusesWhatIsOutOfRangeOrNaN) {
  const double nan = std::nan("");
  const auto refuses = [](auto&& change) {
    FlirtParams params;
    change(params);
    EXPECT_THROW(FlirtDetector detector(params), std::invalid_argument);
  };
  refuses([&](FlirtParams& p) { p.scales = 0; });
  refuses([&](FlirtParams& p) { p.base_sigma = nan; });
  refuses([&](FlirtParams& p) { p.base_sigma = 0.006; });  // an angle, for a length
  refuses([&](FlirtParams& p) { p.sigma_step = 1.0; });
  refuses([&](FlirtParams& p) { p.min_peak = -0.1; });
  refuses([&](FlirtParams& p) { p.min_difference = nan; });
  refuses([&](FlirtParams& p) { p.noise_window = -1.0; });
  refuses([&](FlirtParams& p) { p.max_gap = 0.0; });
  refuses([&](FlirtParams& p) { p.suppression_radius = nan; });
  EXPECT_NO_THROW(validate(flirt_range_params()));
}

}  // namespace
}  // namespace falko_slam
