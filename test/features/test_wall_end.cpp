// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/wall_end.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

LaserScan scan_of(const Scene& scene, const Pose2& pose = {}) {
  auto random = test::seeded_random();
  return test::closed_scan(scene, pose, 720, 0.0, random);
}

// A wall of 2 m in front of the laser, in the middle of a large room.
Scene free_standing_wall() {
  Scene scene;
  scene.add_box({}, {20.0, 20.0});
  scene.walls.push_back({{3.0, -1.0}, {3.0, 1.0}});
  return scene;
}

TEST(WallEnds, LieAtTheEndsOfAWallAndPointAlongIt) {
  const LaserScan scan = scan_of(free_standing_wall());
  const auto ends = find_wall_ends(scan);
  ASSERT_EQ(ends.size(), 2U);
  // Less than the next beam would be farther along the wall.
  const double step = 3.0 * scan.angle_increment / std::pow(std::cos(std::atan2(1.0, 3.0)), 2.0);
  EXPECT_LT((ends[0].position - Eigen::Vector2d(3.0, -1.0)).norm(), step);
  EXPECT_LT((ends[1].position - Eigen::Vector2d(3.0, 1.0)).norm(), step);
  // The laser gives single precision, 1e-7 of 3 m over 8 cm of wall.
  EXPECT_NEAR(ends[0].orientation, 0.5 * kPi, 1e-5);
  EXPECT_NEAR(ends[1].orientation, -0.5 * kPi, 1e-5);
}

TEST(WallEnds, TellTheirBeamAndTheLengthOfWallLookedAt) {
  const LaserScan scan = scan_of(free_standing_wall());
  const WallEndParams params;
  for (const Keypoint& end : find_wall_ends(scan, params)) {
    EXPECT_EQ(end.position, scan.point(end.beam));
    const auto steps = static_cast<std::size_t>(params.wall_steps);
    const std::size_t inner = end.position.y() < 0.0 ? end.beam + steps : end.beam - steps;
    EXPECT_NEAR(end.radius, (scan.point(inner) - end.position).norm(), 1e-12);
    EXPECT_EQ(end.score, 0.0);
  }
}

TEST(WallEnds, AreNotWhereNothingIsOccluded) {
  Scene room;
  room.add_box({}, {6.0, 4.0});
  EXPECT_TRUE(find_wall_ends(scan_of(room, {0.4, 0.3, 0.2})).empty());
  EXPECT_TRUE(find_wall_ends(test::round_scan(3.0)).empty());
}

TEST(WallEnds, AreAtOcclusionsOfAtLeastTheJump) {
  const Scene room = test::room_with_pillar();
  EXPECT_FALSE(find_wall_ends(scan_of(room)).empty());
  WallEndParams params;
  params.min_jump = 10.0;  // more than the room's diagonal
  EXPECT_TRUE(find_wall_ends(scan_of(room), params).empty());
}

TEST(WallEnds, NeedAWallBehindThem) {
  std::vector<double> ranges(360, 5.0);
  for (std::size_t i = 100; i < 103; ++i) ranges[i] = 2.0;  // two steps wide
  EXPECT_TRUE(find_wall_ends(test::circle_of(ranges)).empty());
  WallEndParams params;
  params.wall_steps = 2;
  EXPECT_EQ(find_wall_ends(test::circle_of(ranges), params).size(), 2U);
}

TEST(WallEnds, AreFoundAcrossTheSeamOfAClosedScan) {
  std::vector<double> ranges(360, 5.0);
  for (const std::size_t beam : {358U, 359U, 0U, 1U, 2U}) ranges[beam] = 2.0;
  const auto ends = find_wall_ends(test::circle_of(ranges));
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0].beam, 2U);
  EXPECT_EQ(ends[1].beam, 358U);
}

TEST(WallEnds, AreNotFoundAcrossTheEndsOfAnOpenScan) {
  std::vector<double> ranges(360, 5.0);
  for (const std::size_t beam : {358U, 359U, 0U, 1U, 2U}) ranges[beam] = 2.0;
  LaserScan scan = test::circle_of(ranges);
  scan.closed = false;
  EXPECT_TRUE(find_wall_ends(scan).empty());
}

TEST(WallEnds, AreNotBesideInvalidBeams) {
  std::vector<double> ranges(360, test::kNoRange);
  for (std::size_t i = 100; i < 120; ++i) ranges[i] = 2.0;
  EXPECT_TRUE(find_wall_ends(test::circle_of(ranges)).empty());
}

TEST(WallEnds, TurnWithAClosedScan) {
  const LaserScan scan = scan_of(test::room_with_pillar(), {0.2, -0.1, 0.3});
  const auto ends = find_wall_ends(scan);
  ASSERT_FALSE(ends.empty());
  for (const std::size_t turn : {1U, 180U, 361U, 719U}) {
    const Pose2 back(0.0, 0.0, static_cast<double>(turn) * scan.angle_increment);
    const auto turned = find_wall_ends(with_beams_rotated(scan, turn));
    ASSERT_EQ(turned.size(), ends.size());
    for (const Keypoint& end : turned) {
      const auto same = std::find_if(ends.begin(), ends.end(), [&](const Keypoint& other) {
        return other.beam == (end.beam + turn) % scan.size() &&
               std::abs(angle_between(other.orientation, end.orientation + back.theta())) < 1e-9;
      });
      ASSERT_NE(same, ends.end()) << "beam " << end.beam;
      EXPECT_LT((back * end.position - same->position).norm(), 1e-9);
    }
  }
}

TEST(WallEnds, SurviveScansOfFewBeams) {
  EXPECT_TRUE(find_wall_ends(LaserScan()).empty());
  for (const std::size_t beams : {1U, 2U, 3U}) {
    EXPECT_TRUE(find_wall_ends(test::round_scan(2.0, beams)).empty());
    EXPECT_TRUE(find_wall_ends(test::round_scan(test::kNoRange, beams)).empty());
  }
}

TEST(WallEndParams, NamesFieldAndValueOfWhatIsWrong) {
  const auto error_of = [](auto&& change) {
    WallEndParams params;
    change(params);
    try {
      find_wall_ends(test::round_scan(2.0), params);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const double nan = std::nan("");
  EXPECT_EQ(error_of([](auto& p) { p.min_jump = 0.01; }).find("min_jump = 0.01: "), 0U);
  EXPECT_EQ(error_of([](auto& p) { p.wall_steps = 0; }).find("wall_steps = 0: "), 0U);
  EXPECT_EQ(error_of([&](auto& p) { p.surface.max_step = nan; }).find("max_step = nan: "), 0U);
  EXPECT_EQ(error_of([](auto& p) { p.surface.step_ratio = -1.0; }).find("step_ratio = -1: "), 0U);
}

}  // namespace
}  // namespace falko_slam
