// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/layout_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/simulated_vehicle.hpp"
#include "support/simulated_worlds.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using test::kBegin;

FollowStep path(std::vector<Eigen::Vector2d> through, const std::string& name = "",
                bool backward = false) {
  FollowStep step;
  step.through = std::move(through);
  step.name = name;
  step.backward = backward;
  return step;
}

// A vehicle that knows exactly where it is, led until it is done.
class LedVehicle {
 public:
  LedVehicle(std::vector<LayoutStep> steps, const Pose2& start)
      : vehicle_(model_, start, kBegin, 1), follower_(params(), {"test", std::move(steps)}) {}

  void drive(double most_seconds) {
    const Time end = vehicle_.time() + from_seconds(most_seconds);
    while (!follower_.done() && vehicle_.time() < end) step(vehicle_.world_T_base());
  }
  void step(const std::optional<Pose2>& known) {
    const WheelCommand command =
        follower_.next({vehicle_.time(), known, speed_, vehicle_.steering()});
    if (command.wheel_speed != 0.0)
      farthest_ = std::max(farthest_, std::abs(follower_.cross_track()));
    const Pose2 before = vehicle_.world_T_base();
    vehicle_.drive(test::kControlPeriod, command);
    speed_ = (before.inverse() * vehicle_.world_T_base()).x() / to_seconds(test::kControlPeriod);
  }

  LayoutFollowerParams params() const {
    LayoutFollowerParams params;
    params.tricycle = model_.tricycle;
    return params;
  }
  const LayoutFollower& follower() const { return follower_; }
  const Pose2& pose() const { return vehicle_.world_T_base(); }
  double speed() const { return speed_; }
  double farthest() const { return farthest_; }

 private:
  VehicleModel model_;
  SimulatedVehicle vehicle_;
  LayoutFollower follower_;
  double speed_ = 0.0;
  double farthest_ = 0.0;  // from the path [m]
};

TEST(LayoutFollower, HaltsAtTheEndOfLinesAndCurves) {
  LedVehicle vehicle(
      {path({{8.0, 0.0}, {8.0, 6.0}}, "A"), WaitStep{1.0}, path({{8.0, 10.0}, {2.0, 10.0}}, "B")},
      {});
  vehicle.drive(120.0);
  ASSERT_TRUE(vehicle.follower().done());
  const std::vector<Halt>& halts = vehicle.follower().halts();
  ASSERT_EQ(halts.size(), 2U);
  EXPECT_EQ(halts[0].name, "A");
  EXPECT_NEAR(halts[0].map_T_planned.x(), 8.0, 1e-9);
  EXPECT_NEAR(halts[0].map_T_planned.y(), 6.0, 1e-9);
  EXPECT_NEAR(halts[0].map_T_planned.theta(), kPi / 2.0, 1e-6);
  for (const Halt& halt : halts) {
    EXPECT_LT((halt.map_T_base.translation() - halt.map_T_planned.translation()).norm(), 2e-3);
    EXPECT_NEAR(angle_between(halt.map_T_base.theta(), halt.map_T_planned.theta()), 0.0, 2e-3);
    EXPECT_FALSE(halt.after_curve);
  }
  EXPECT_LT(vehicle.farthest(), 0.02);
}

TEST(LayoutFollower, BacksIntoADock) {
  LedVehicle vehicle({path({{6.0, 0.0}}), path({{3.0, 0.0}, {3.0, -4.0}}, "dock", true)}, {});
  vehicle.drive(120.0);
  ASSERT_TRUE(vehicle.follower().done());
  const Halt& halt = vehicle.follower().halts().back();
  EXPECT_NEAR(halt.map_T_planned.theta(), kPi / 2.0, 1e-6);  // its front looks out
  EXPECT_LT((vehicle.pose().translation() - Eigen::Vector2d(3.0, -4.0)).norm(), 3e-3);
  EXPECT_NEAR(vehicle.pose().theta(), kPi / 2.0, 5e-3);
  EXPECT_LT(vehicle.farthest(), 0.02);
}

TEST(LayoutFollower, ComesBackToItsPath) {
  LedVehicle vehicle({path({{10.0, 0.0}}), path({{20.0, 0.0}}, "end")}, {0.0, 0.0, 0.3});
  vehicle.drive(120.0);
  ASSERT_TRUE(vehicle.follower().done());
  EXPECT_LT(std::abs(vehicle.pose().y()), 1e-3);
  EXPECT_LT(std::abs(vehicle.pose().theta()), 1e-3);
}

TEST(LayoutFollower, StandsWithoutAPoseAndGoesOnWithOne) {
  LedVehicle vehicle({path({{8.0, 0.0}}, "end")}, {});
  vehicle.drive(4.0);
  ASSERT_GT(vehicle.speed(), 0.5);
  for (int i = 0; i < 150; ++i) vehicle.step(std::nullopt);
  EXPECT_NEAR(vehicle.speed(), 0.0, 1e-9);
  EXPECT_FALSE(vehicle.follower().done());
  vehicle.drive(60.0);
  EXPECT_TRUE(vehicle.follower().done());
  EXPECT_NEAR(vehicle.pose().x(), 8.0, 2e-3);
}

TEST(LayoutFollower, TellsACurveBeforeAHalt) {
  FollowStep narrow = path({{5.0, 0.0}, {5.0, 1.25}}, "A");
  narrow.corner_radius = 1.25;
  narrow.speed = 0.5;
  LedVehicle vehicle({narrow}, {});
  vehicle.drive(60.0);
  ASSERT_EQ(vehicle.follower().halts().size(), 1U);
  EXPECT_TRUE(vehicle.follower().halts()[0].after_curve);
}

TEST(LayoutFollower, BeginsAgainWhereItEnded) {
  LedVehicle vehicle({path({{5.0, 0.0}}, "A"), path({{2.0, 0.0}}, "B", true)}, {2.0, 0.0, 0.0});
  vehicle.drive(60.0);
  ASSERT_TRUE(vehicle.follower().done());
  LayoutFollower again(vehicle.params(), {"test", {path({{5.0, 0.0}})}});
  again.next({kBegin, Pose2(5.0, 0.0, 0.0), 0.0, 0.0});
  again.begin_again();
  EXPECT_FALSE(again.done());
  EXPECT_TRUE(again.halts().empty());
}

TEST(LayoutFollower, RefusesWhatCannotBeFollowed) {
  EXPECT_THROW(LayoutFollower({}, {"empty", {}}), std::invalid_argument);
  LayoutFollowerParams params;
  params.response = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.steer_gain = 0.0;
  EXPECT_THROW(LayoutFollower(params, {"test", {WaitStep{1.0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
