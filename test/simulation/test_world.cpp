// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/world.hpp"

#include <gtest/gtest.h>

#include "falko_slam/geometry/angles.hpp"
#include "support/poses.hpp"

namespace falko_slam {
namespace {

using Repeat = BodyMotion::Repeat;

// 4 m at 2 m/s, a quarter turn where it stands, 2 m back down.
BodyMotion errand(Repeat repeat) {
  return {{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 0.0, -0.5 * kPi}, {4.0, -2.0, -0.5 * kPi}},
          2.0,
          repeat};
}

TEST(AddBox, AddsFourFacesAroundARectangle) {
  Shape shape;
  add_box(shape, {1.0, 2.0, 0.5 * kPi}, {4.0, 2.0}, 3);

  ASSERT_EQ(shape.faces.size(), 4U);
  double around = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const Face& face = shape.faces[i];
    EXPECT_EQ(face.surface, 3U);
    EXPECT_TRUE(face.to.isApprox(shape.faces[(i + 1) % 4].from));
    EXPECT_NEAR(std::abs(face.from.x() - 1.0), 1.0, 1e-12);
    EXPECT_NEAR(std::abs(face.from.y() - 2.0), 2.0, 1e-12);
    around += (face.to - face.from).norm();
    sum += face.from;
  }
  EXPECT_NEAR(around, 12.0, 1e-12);
  EXPECT_TRUE((0.25 * sum).isApprox(Eigen::Vector2d(1.0, 2.0)));
}

TEST(BodyMotion, MovesAtItsSpeedAndTurnsAtOneRadianPerSecond) {
  const BodyMotion motion = errand(Repeat::kOnce);
  test::expect_near(pose_at(motion, -1.0), {0.0, 0.0, 0.0}, 1e-12);
  test::expect_near(pose_at(motion, 0.0), {0.0, 0.0, 0.0}, 1e-12);
  test::expect_near(pose_at(motion, 0.5), {1.0, 0.0, 0.0}, 1e-12);
  test::expect_near(pose_at(motion, 2.0), {4.0, 0.0, 0.0}, 1e-12);
  test::expect_near(pose_at(motion, 3.0), {4.0, 0.0, -1.0}, 1e-12);
  test::expect_near(pose_at(motion, 2.0 + 0.5 * kPi + 0.25), {4.0, -0.5, -0.5 * kPi}, 1e-12);
  test::expect_near(pose_at(motion, 100.0), {4.0, -2.0, -0.5 * kPi}, 1e-12);
}

TEST(BodyMotion, TurnsEvenlyAndTheShortWayRound) {
  const BodyMotion motion{{{0.0, 0.0, 3.0}, {2.0, 0.0, -3.0}}, 1.0, Repeat::kOnce};
  test::expect_near(pose_at(motion, 1.0), {1.0, 0.0, kPi}, 1e-12);
  test::expect_near(pose_at(motion, 0.5), {0.5, 0.0, 3.0 + 0.25 * (kTwoPi - 6.0)}, 1e-12);
}

TEST(BodyMotion, GoesRoundFromTheLastPlaceToTheFirst) {
  const BodyMotion motion{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 4.0, 0.0}}, 1.0, Repeat::kRound};
  test::expect_near(pose_at(motion, 7.0 + 2.5), {1.5, 2.0, 0.0}, 1e-12);
  for (const double seconds : {0.0, 1.5, 4.0, 8.0, 11.5}) {
    const Pose2 first = pose_at(motion, seconds);
    test::expect_near(pose_at(motion, seconds + 36.0), {first.x(), first.y(), first.theta()},
                      1e-12);
  }
}

TEST(BodyMotion, GoesBackTheWayItCame) {
  const BodyMotion motion = errand(Repeat::kBackAndForth);
  const double once = 3.0 + 0.5 * kPi;
  for (const double seconds : {0.0, 1.0, 2.5, 4.0, once}) {
    const Pose2 there = pose_at(errand(Repeat::kOnce), seconds);
    test::expect_near(pose_at(motion, seconds), {there.x(), there.y(), there.theta()}, 1e-12);
    test::expect_near(pose_at(motion, 2.0 * once - seconds), {there.x(), there.y(), there.theta()},
                      1e-12);
    test::expect_near(pose_at(motion, 20.0 * once + seconds), {there.x(), there.y(), there.theta()},
                      1e-12);
  }
}

TEST(BodyMotion, StandsWhereItHasOnePlaceOnly) {
  for (const Repeat repeat : {Repeat::kOnce, Repeat::kRound, Repeat::kBackAndForth}) {
    test::expect_near(pose_at({{{1.0, 2.0, 0.3}}, 1.0, repeat}, 5.0), {1.0, 2.0, 0.3}, 1e-12);
    test::expect_near(pose_at({{{1.0, 2.0, 0.3}, {1.0, 2.0, 0.3}}, 1.0, repeat}, 5.0),
                      {1.0, 2.0, 0.3}, 1e-12);
    test::expect_near(pose_at({{}, 1.0, repeat}, 5.0), {0.0, 0.0, 0.0}, 1e-12);
  }
}

}  // namespace
}  // namespace falko_slam
