// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/driver.hpp"
#include "falko_slam/simulation/scenario.hpp"
#include "rounded_path.hpp"
#include "support/simulated_worlds.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using test::kBegin;

struct Led {
  SimulatedVehicle vehicle;
  double farthest_from_line = 0.0;  // the x axis [m]
};

Led led(const std::vector<DriveStep>& steps, const Pose2& start = {}) {
  const VehicleModel model;
  Led result{SimulatedVehicle(model, start, kBegin, 1)};
  const auto driver = scenario_driver(steps, model);
  for (int i = 0; i < 100000; ++i) {
    const auto input = driver->next(result.vehicle, test::kControlPeriod);
    if (!input) break;
    result.vehicle.drive(test::kControlPeriod, std::get<WheelCommand>(*input));
    result.farthest_from_line =
        std::max(result.farthest_from_line, std::abs(result.vehicle.world_T_base().y()));
  }
  EXPECT_EQ(result.vehicle.wheel_speed(), 0.0);
  return result;
}

TEST(ScenarioDriver, WaitsAsLongAsItIsTold) {
  const Led result = led({WaitStep{2.5}});

  EXPECT_NEAR(to_seconds(result.vehicle.time() - kBegin), 2.5, 0.021);
  EXPECT_EQ(result.vehicle.world_T_base().translation().norm(), 0.0);
}

TEST(ScenarioDriver, EndsArcsAfterTheirTurn) {
  for (const double speed : {0.5, -0.5}) {
    for (const double steering : {0.4, -0.4}) {
      const Led result = led({ArcStep{speed, steering, kPi / 2.0, 0.0}});
      const double expected = std::copysign(kPi / 2.0, speed * steering);
      EXPECT_NEAR(result.vehicle.world_T_base().theta(), expected, 0.01);
    }
  }
}

TEST(ScenarioDriver, SteersAtRestBeforeEachArc) {
  const VehicleModel model;
  SimulatedVehicle vehicle(model, {30.1, -7.3, 0.77}, kBegin, 1);
  const auto driver = scenario_driver(
      {ArcStep{0.5, 0.2, 0.5, 0.0}, WaitStep{0.5}, ArcStep{0.5, 0.6, 0.5, 0.0}}, model);
  while (const auto input = driver->next(vehicle, test::kControlPeriod)) {
    const double before = vehicle.steering();
    vehicle.drive(test::kControlPeriod, std::get<WheelCommand>(*input));
    if (vehicle.wheel_speed() != 0.0) {
      EXPECT_EQ(vehicle.steering(), before);
    }
  }
}

TEST(ScenarioDriver, EndsArcsAfterTheirWay) {
  const Led result = led({ArcStep{0.8, 0.0, 0.0, 3.0}});

  EXPECT_NEAR(result.vehicle.world_T_base().translation().norm(), 3.0, 0.01);
}

TEST(ScenarioDriver, FollowsALineToItsEnd) {
  const Led forward = led({FollowStep{{{8.0, 0.0}}, 0.8, 1.5, false}}, {0.0, 0.0, 0.1});
  EXPECT_LT((forward.vehicle.world_T_base().translation() - Eigen::Vector2d(8.0, 0.0)).norm(),
            0.02);
  EXPECT_NEAR(forward.vehicle.world_T_base().theta(), 0.0, 0.01);
  EXPECT_LT(forward.farthest_from_line, 0.15);

  const Led backward = led({FollowStep{{{-6.0, 0.0}}, 0.5, 1.5, true}});
  EXPECT_LT((backward.vehicle.world_T_base().translation() - Eigen::Vector2d(-6.0, 0.0)).norm(),
            0.02);
  EXPECT_LT(backward.farthest_from_line, 0.05);
}

TEST(ScenarioDriver, DoesOneStepAfterTheOther) {
  const Led result = led({FollowStep{{{5.0, 0.0}, {5.0, 5.0}}, 0.8, 1.5, false}, WaitStep{1.0},
                          FollowStep{{{5.0, 1.0}}, 0.5, 1.5, true}});

  EXPECT_LT((result.vehicle.world_T_base().translation() - Eigen::Vector2d(5.0, 1.0)).norm(), 0.05);
  EXPECT_NEAR(result.vehicle.world_T_base().theta(), kPi / 2.0, 0.05);
}

TEST(RoundedPath, RoundsCornersByTheirRadius) {
  const RoundedPath path({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}}, 2.0);

  EXPECT_NEAR(path.length(), 8.0 + kPi + 8.0, 1e-3);
  const Eigen::Vector2d middle = path.at(8.0 + kPi / 2.0);
  EXPECT_NEAR((middle - Eigen::Vector2d(8.0, 2.0)).norm(), 2.0, 1e-3);
  EXPECT_LT((path.at(path.length() + 3.0) - Eigen::Vector2d(10.0, 13.0)).norm(), 1e-6);
  EXPECT_NEAR(path.nearest({4.0, 1.0}, 0.0, 20.0), 4.0, 0.02);
}

// The arc takes the whole second line but for what rounding leaves of it.
TEST(RoundedPath, EndsWhereACornerEnds) {
  const RoundedPath path({{0.0, 0.0}, {5.0, 0.0}, {5.0, 1.25}}, 1.25);
  EXPECT_LT((path.at(path.length()) - Eigen::Vector2d(5.0, 1.25)).norm(), 1e-9);
}

TEST(RoundedPath, TakesLessRadiusWhereThereIsNoRoom) {
  const RoundedPath path({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {2.0, 1.0}}, 5.0);

  EXPECT_LT(path.length(), 3.0);
  EXPECT_LT((path.at(path.length()) - Eigen::Vector2d(2.0, 1.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace falko_slam
