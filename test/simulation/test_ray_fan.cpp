// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ray_fan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "support/scene.hpp"
#include "support/seeds.hpp"
#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using test::uniform;

// A scanner that turns once while it moves on an arc.
RayFan moving_fan(std::size_t beams, const Pose2& start, const Eigen::Vector3d& way) {
  RayFan fan;
  fan.resize(beams);
  const Pose2 middle = start * Pose2::exp(0.5 * way);
  fan.center = middle.translation();
  double heading = start.theta();
  for (std::size_t i = 0; i < beams; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(beams);
    const Pose2 pose = start * Pose2::exp(share * way);
    heading += angle_between(heading, pose.theta());
    fan.bearing[i] = heading - kPi + share * kTwoPi;
    fan.x[i] = pose.x();
    fan.y[i] = pose.y();
    fan.dx[i] = std::cos(fan.bearing[i]);
    fan.dy[i] = std::sin(fan.bearing[i]);
    fan.reach = std::max(fan.reach, (pose.translation() - fan.center).norm());
  }
  return fan;
}

double brute_force(const Scene& scene, const RayFan& fan, std::size_t i) {
  return scene.cast({fan.x[i], fan.y[i], fan.bearing[i]});
}

TEST(RayFan, MeetsWhatBruteForceMeets) {
  auto random = test::seeded_random();
  for (int trial = 0; trial < 300; ++trial) {
    Scene scene;
    Shape shape;
    const int faces = 1 + trial % 40;
    for (int i = 0; i < faces; ++i) {
      const Eigen::Vector2d from(uniform(random, -8.0, 8.0), uniform(random, -8.0, 8.0));
      const double length = i % 3 == 0 ? 0.3 : 6.0;
      const Eigen::Vector2d to =
          from + length * Eigen::Vector2d(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      scene.walls.push_back({from, to});
      shape.faces.push_back({from, to, test::kMatt});
    }
    const Pose2 start(uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0),
                      uniform(random, -kPi, kPi));
    RayFan fan =
        moving_fan(257, start, {uniform(random, -0.5, 0.5), 0.0, uniform(random, -0.4, 0.4)});

    cast(shape, test::empty_world().surfaces, fan);

    for (std::size_t i = 0; i < fan.beams(); ++i) {
      const double expected = brute_force(scene, fan, i);
      if (std::isinf(expected)) {
        EXPECT_TRUE(std::isinf(fan.range[i])) << "trial " << trial << " beam " << i;
      } else {
        EXPECT_NEAR(fan.range[i], expected, 1e-9) << "trial " << trial << " beam " << i;
      }
    }
  }
}

TEST(RayFan, MeetsCylindersWhereCircleAndLineMeet) {
  Shape shape;
  shape.cylinders = {{{5.0, 0.0}, 1.0, test::kMatt}, {{-4.0, 3.0}, 0.5, test::kMatt}};
  RayFan fan = moving_fan(1440, {}, Eigen::Vector3d::Zero());

  cast(shape, test::empty_world().surfaces, fan);

  for (std::size_t i = 0; i < fan.beams(); ++i) {
    double expected = std::numeric_limits<double>::infinity();
    for (const Cylinder& cylinder : shape.cylinders) {
      const double distance = cylinder.center.norm();
      const double aside =
          angle_between(std::atan2(cylinder.center.y(), cylinder.center.x()), fan.bearing[i]);
      const double miss = distance * std::sin(aside);
      if (std::abs(miss) > cylinder.radius || std::abs(aside) > 1.5) continue;
      expected =
          distance * std::cos(aside) - std::sqrt(cylinder.radius * cylinder.radius - miss * miss);
    }
    if (std::isinf(expected)) {
      EXPECT_TRUE(std::isinf(fan.range[i])) << i;
    } else {
      EXPECT_NEAR(fan.range[i], expected, 1e-9) << i;
    }
  }
}

TEST(RayFan, BringsBackLightByIncidence) {
  Shape shape;
  shape.faces = {{{2.0, -10.0}, {2.0, 10.0}, test::kMatt}};
  RayFan fan = moving_fan(360, {}, Eigen::Vector3d::Zero());

  cast(shape, test::empty_world().surfaces, fan);

  EXPECT_NEAR(fan.light[180], 0.5, 1e-12);
  EXPECT_NEAR(fan.light[180 + 60], 0.5 * std::cos(degrees_to_radians(60.0)), 1e-12);
  EXPECT_EQ(fan.light[0], 0.0);
}

TEST(RayFan, MeetsAThingWhereItIsWhenTheBeamLooks) {
  Body body;
  add_box(body.shape, {}, {1.0, 1.0}, test::kMatt);
  body.motion = {{{5.0, -2.0, 0.3}, {5.0, 2.0, 1.3}}, 2.0, BodyMotion::Repeat::kOnce};
  RayFan fan = moving_fan(720, {}, {0.2, 0.0, 0.1});
  std::vector<double> seconds(720);
  for (std::size_t i = 0; i < 720; ++i) seconds[i] = 0.4 + static_cast<double>(i) / 720.0;

  cast(body, test::empty_world().surfaces, seconds, fan);

  int hits = 0;
  for (std::size_t i = 0; i < fan.beams(); ++i) {
    Scene scene;
    scene.add_box(pose_at(body.motion, seconds[i]), {1.0, 1.0});
    const double expected = brute_force(scene, fan, i);
    hits += std::isfinite(expected) ? 1 : 0;
    if (std::isfinite(expected)) {
      EXPECT_NEAR(fan.range[i], expected, 1e-9) << i;
    } else {
      EXPECT_TRUE(std::isinf(fan.range[i])) << i;
    }
  }
  EXPECT_GT(hits, 15);
}

TEST(RayFan, MeetsAThingOnlyWhileItIsThere) {
  Body body;
  add_box(body.shape, {}, {1.0, 30.0}, test::kMatt);
  body.motion.through = {{5.0, 0.0, 0.0}};
  body.appears = 1.0;
  body.disappears = 2.0;
  for (const auto& [second, there] :
       {std::pair{0.9, false}, {1.0, true}, {1.9, true}, {2.0, false}}) {
    RayFan fan = moving_fan(360, {}, Eigen::Vector3d::Zero());
    cast(body, test::empty_world().surfaces, std::vector<double>(360, second), fan);
    EXPECT_EQ(std::isfinite(fan.range[180]), there) << second;
  }
}

}  // namespace
}  // namespace falko_slam
