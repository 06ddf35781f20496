// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

Scene single_wall(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Scene scene;
  scene.walls = {{from, to}};
  return scene;
}

TEST(Scene, CastsOntoAWallUnderAnyAngle) {
  const Scene scene = single_wall({2.0, -50.0}, {2.0, 50.0});
  for (const double angle : {0.0, 1e-9, 0.5, -1.2, 1.5}) {
    EXPECT_NEAR(scene.cast({0.0, 0.0, angle}), 2.0 / std::cos(angle), 1e-9) << angle;
  }
}

TEST(Scene, CastsFromTheMiddleOfABox) {
  Scene scene;
  scene.add_box({1.0, 2.0, 0.4}, {6.0, 4.0});
  for (double angle = -kPi; angle < kPi; angle += 0.1) {
    const double expected =
        std::min(3.0 / std::abs(std::cos(angle)), 2.0 / std::abs(std::sin(angle)));
    EXPECT_NEAR(scene.cast({1.0, 2.0, 0.4 + angle}), expected, 1e-9) << angle;
  }
}

TEST(Scene, TakesTheFirstWall) {
  Scene scene = single_wall({5.0, -1.0}, {5.0, 1.0});
  scene.walls.push_back({{3.0, -1.0}, {3.0, 1.0}});
  scene.walls.push_back({{4.0, -1.0}, {4.0, 1.0}});
  EXPECT_EQ(scene.cast({}), 3.0);
}

TEST(Scene, SeesNothingBesideBehindAndAlongAWall) {
  const Scene scene = single_wall({2.0, -1.0}, {2.0, 1.0});
  EXPECT_TRUE(std::isinf(scene.cast({0.0, 1.5, 0.0})));
  EXPECT_TRUE(std::isinf(scene.cast({3.0, 0.0, 0.0})));
  EXPECT_TRUE(std::isinf(single_wall({1.0, 0.0}, {2.0, 0.0}).cast({})));
  EXPECT_TRUE(std::isinf(Scene{}.cast({})));
}

TEST(Scene, EndsOfAWallBelongToIt) {
  const Scene scene = single_wall({2.0, 0.0}, {2.0, 1.0});
  EXPECT_EQ(scene.cast({0.0, 0.0, 0.0}), 2.0);
  EXPECT_EQ(scene.cast({0.0, 1.0, 0.0}), 2.0);
}

TEST(Scene, IsSeenTheSameAfterMovingWithTheLaser) {
  auto random = test::seeded_random();
  const auto random_point = [&] {
    return Eigen::Vector2d(test::uniform(random, -9.0, 9.0), test::uniform(random, -9.0, 9.0));
  };
  for (int run = 0; run < 200; ++run) {
    Scene scene;
    for (int i = 0; i < 10; ++i) scene.walls.push_back({random_point(), random_point()});
    const Pose2 ray(random_point(), test::uniform(random, -kPi, kPi));
    const Pose2 motion(random_point(), test::uniform(random, -kPi, kPi));
    Scene moved = scene;
    for (Wall& wall : moved.walls) wall = {motion * wall.from, motion * wall.to};
    const double before = scene.cast(ray);
    const double after = moved.cast(motion * ray);
    EXPECT_TRUE(before == after || std::abs(before - after) < 1e-6 * (1.0 + before))
        << before << " " << after;
  }
}

TEST(Scene, ABoxHasFourWallsAroundItsMiddle) {
  Scene scene;
  const Pose2 center(1.0, -2.0, 0.7);
  scene.add_box(center, {6.0, 4.0});
  ASSERT_EQ(scene.walls.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.walls[i].to, scene.walls[(i + 1) % 4].from);
    const Eigen::Vector2d corner = center.inverse() * scene.walls[i].from;
    EXPECT_NEAR(std::abs(corner.x()), 3.0, 1e-12);
    EXPECT_NEAR(std::abs(corner.y()), 2.0, 1e-12);
  }
}

}  // namespace
}  // namespace falko_slam
