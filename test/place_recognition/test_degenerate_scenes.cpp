// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/place_recognition/loop_detector.hpp"
#include "support/drives.hpp"
#include "support/hand_made_scans.hpp"

// Places that look like others: no loop is better than a wrong one.
namespace falko_slam {
namespace {

using test::straight;

void expect_nothing_wrong_accepted(const std::vector<PosedScan>& scans, std::size_t first = 0) {
  LoopDetector detector = test::detector_of(scans);
  std::size_t looked_at = 0;
  for (std::size_t source = first; source < scans.size(); ++source) {
    const LoopDetection detection = detector.detect({source});
    looked_at += detection.candidates.size();
    const LoopCandidate* loop = detection.accepted();
    if (loop == nullptr) continue;
    const Keyframe& target = detector.keyframes()[loop->target.value];
    const Pose2& pose = loop->target_T_source->pose;
    EXPECT_TRUE(test::is_right(target, scans[source].map_T_laser, pose))
        << source << " at " << scans[source].map_T_laser << " with " << loop->target.value << " at "
        << target.odom_T_laser << ": off by "
        << test::error_of(target, scans[source].map_T_laser, pose) << ", scan score "
        << loop->scan_score << ", score " << loop->score;
  }
  EXPECT_GT(looked_at, 0U);
}

std::size_t accepted_in(const std::vector<PosedScan>& scans) {
  LoopDetector detector = test::detector_of(scans);
  const auto detections = test::detect_all(detector);
  return static_cast<std::size_t>(
      std::count_if(detections.begin(), detections.end(),
                    [](const LoopDetection& detection) { return detection.accepted(); }));
}

// The same scan along a way that is long enough for loops.
std::vector<PosedScan> all_the_same(const LaserScan& scan) {
  std::vector<PosedScan> scans;
  for (const Pose2& pose : straight({}, 30.0, 1.0)) scans.push_back({scan, pose});
  return scans;
}

TEST(DegenerateScenes, NoLoopWithoutAValidBeam) {
  EXPECT_EQ(accepted_in(all_the_same(test::round_scan(test::kNoRange))), 0U);
}

TEST(DegenerateScenes, NoLoopOfARoundRoom) {
  EXPECT_EQ(accepted_in(all_the_same(test::round_scan(4.0))), 0U);
}

TEST(DegenerateScenes, NoLoopOfASingleCorner) {
  Scene scene;
  scene.walls = {{{2.0, -2.0}, {2.0, 2.0}}, {{2.0, 2.0}, {-2.0, 2.0}}};
  auto random = test::seeded_random();
  EXPECT_EQ(accepted_in(all_the_same(test::closed_scan(scene, {}, 360, 0.01, random))), 0U);
}

TEST(DegenerateScenes, NoWrongLoopInACorridorWithoutAnEnd) {
  Scene scene;
  scene.walls = {{{-500.0, 1.5}, {500.0, 1.5}}, {{-500.0, -1.2}, {500.0, -1.2}}};
  auto random = test::seeded_random();
  expect_nothing_wrong_accepted(
      test::drive(scene, test::joined(straight({}, 15.0, 0.5), straight({}, 15.0, 0.5)), random));
}

// A room without a symmetry.
Scene odd_room() {
  Scene scene;
  scene.add_box({}, {11.0, 8.0});
  scene.add_box({-3.0, 2.4, 0.3}, {1.0, 0.6});
  scene.add_box({2.5, 2.8, 0.0}, {2.0, 0.5});
  scene.add_box({4.2, -1.5, 0.8}, {0.7, 0.7});
  scene.add_box({-1.0, -2.6, 0.0}, {0.5, 0.5});
  scene.add_box({-4.6, -1.8, 0.0}, {0.6, 1.6});
  return scene;
}

// The room, then its copy 100 m away, its y scaled by `side`: 1 or -1.
std::size_t accepted_in_copy(double side) {
  Scene scene = odd_room();
  const Eigen::Vector2d away(100.0, 0.0);
  for (const Wall& wall : odd_room().walls) {
    const auto copy = [&](const Eigen::Vector2d& point) {
      return Eigen::Vector2d(Eigen::Vector2d(point.x(), side * point.y()) + away);
    };
    scene.walls.push_back({copy(wall.from), copy(wall.to)});
  }
  const auto here = straight({-3.5, 0.3, 0.1}, 6.0, 0.4);
  test::Poses there;
  for (const Pose2& pose : here) {
    there.emplace_back(pose.x() + away.x(), side * pose.y(), side * pose.theta());
  }
  auto random = test::seeded_random();
  return accepted_in(test::drive(scene, test::joined(here, there), random));
}

TEST(DegenerateScenes, NoLoopWithTheMirrorImageOfAPlace) {
  EXPECT_GT(accepted_in_copy(1.0), 0U);  // two places alike cannot be told apart
  EXPECT_EQ(accepted_in_copy(-1.0), 0U);
}

// From the point opposite, the other way round, the room looks the same.
TEST(DegenerateScenes, NoWrongLoopInAnEmptyRectangularRoom) {
  const Pose2 turned(0.0, 0.0, kPi);
  for (const double length : {12.0, 8.0, 6.0}) {
    Scene scene;
    scene.add_box({}, {length, 6.0});
    auto random = test::seeded_random();
    const auto way = test::joined(straight({-0.42 * length, -0.7, 0.0}, 0.38 * length, 0.4),
                                  straight({-0.04 * length, 0.7, kPi}, 0.38 * length, 0.4));
    test::Poses opposite;
    for (const Pose2& pose : way) opposite.push_back(turned * pose);
    const auto lap = test::joined(way, opposite);
    expect_nothing_wrong_accepted(test::drive(scene, test::joined(lap, lap), random));
    const auto through = straight({-0.42 * length, 0.0, 0.0}, 0.84 * length, 0.04 * length);
    expect_nothing_wrong_accepted(
        test::drive(scene, test::joined(test::joined(through, through), through), random));
  }
}

// Racks along an aisle without an end: the next gap looks like this one.
TEST(DegenerateScenes, NoWrongLoopAmongEqualShelves) {
  for (const double period : {1.0, 2.8, 4.0}) {
    Scene scene;
    scene.walls = {{{-500.0, 3.0}, {500.0, 3.0}}, {{-500.0, -3.0}, {500.0, -3.0}}};
    for (int i = -60; i <= 60; ++i) {
      for (const double side : {-2.0, 2.0}) {
        scene.add_box({period * i, side, 0.0}, {0.7 * period, 0.6});
      }
    }
    auto random = test::seeded_random();
    expect_nothing_wrong_accepted(
        test::drive(scene, test::joined(straight({}, 30.0, 0.5), straight({}, 30.0, 0.5)), random));
  }
}

// Half a turn maps the building onto itself. On the first lap the other half has not been seen:
// only odometry could tell.
TEST(DegenerateScenes, NoWrongLoopInASymmetricBuilding) {
  Scene scene = office_scene();
  for (const Wall& wall : office_scene().walls) scene.walls.push_back({-wall.from, -wall.to});
  auto random = test::seeded_random();
  const auto lap = office_path(0.5);
  expect_nothing_wrong_accepted(test::drive(scene, test::joined(lap, lap), random), lap.size());
}

}  // namespace
}  // namespace falko_slam
