// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <falko_slam/DriveCommand.h>
#include <falko_slam/OperationPoint.h>
#include <falko_slam/TricycleEncoders.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <std_srvs/SetBool.h>

#include <optional>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/simulation/simulated_vehicle.hpp"
#include "spin_until.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using test::spin_until;

// A vehicle that obeys the node; its time is its own, so that the machine may be slow.
class Led : public ::testing::Test {
 protected:
  void SetUp() override {
    poses_ = node_.advertise<nav_msgs::Odometry>("odometry", 10);
    encoders_ = node_.advertise<TricycleEncoders>("encoders", 10);
    commands_ = node_.subscribe<DriveCommand>(
        "drive_command", 10, [this](const DriveCommandConstPtr& message) { command_ = *message; });
    points_ = node_.subscribe<OperationPoint>(
        "operation_point", 10,
        [this](const OperationPointConstPtr& message) { point_ = *message; });
    ASSERT_TRUE(spin_until([this] {
      return poses_.getNumSubscribers() > 0 && encoders_.getNumSubscribers() > 0 &&
             commands_.getNumPublishers() > 0 && points_.getNumPublishers() > 0;
    }));
  }

  void step() {
    command_.reset();
    encoders_.publish(to_message(vehicle_.reading(), "base_link"));
    nav_msgs::Odometry pose =
        odometry_message(vehicle_.world_T_base(), vehicle_.time(), "map", "base_link");
    pose.twist.twist.linear.x = speed_;
    poses_.publish(pose);
    ASSERT_TRUE(spin_until([this] { return command_.has_value(); }));
    const Pose2 before = vehicle_.world_T_base();
    vehicle_.drive(test::kControlPeriod, WheelCommand{command_->wheel_speed, command_->steering});
    speed_ = (before.inverse() * vehicle_.world_T_base()).x() / to_seconds(test::kControlPeriod);
  }
  bool pause(bool paused) {
    std_srvs::SetBool call;
    call.request.data = static_cast<std::uint8_t>(paused);
    return ros::service::call("layout_follower/pause", call) && call.response.success;
  }

  static VehicleModel model() {
    VehicleModel model;
    model.tricycle = {1.358, 2.5e-4, 0.0, 0.0};
    return model;
  }

  ros::NodeHandle node_;
  ros::Publisher poses_, encoders_;
  ros::Subscriber commands_, points_;
  std::optional<DriveCommand> command_;
  std::optional<OperationPoint> point_;
  double speed_ = 0.0;  // [m/s]
  // One for all tests, as the node is.
  static inline SimulatedVehicle vehicle_{model(), {}, Time(std::chrono::seconds(100)), 1};
};

TEST_F(Led, DrivesHaltsWithoutAPoseAndWhilePausedAndArrives) {
  for (int i = 0; i < 40; ++i) step();
  EXPECT_GT(command_->wheel_speed, 0.2);

  command_.reset();  // no pose any more
  EXPECT_TRUE(spin_until([this] { return command_ && command_->wheel_speed == 0.0; }));

  ASSERT_TRUE(pause(true));
  step();
  EXPECT_EQ(command_->wheel_speed, 0.0);
  ASSERT_TRUE(pause(false));

  for (int i = 0; i < 2000 && !point_; ++i) step();
  ASSERT_TRUE(point_);
  EXPECT_EQ(point_->name, "A");
  EXPECT_EQ(point_->header.frame_id, "map");
  EXPECT_NEAR(point_->planned.y, 1.5, 1e-9);
  EXPECT_LT((vehicle_.world_T_base().translation() - Eigen::Vector2d(1.5, 1.5)).norm(), 0.05);
  step();
  EXPECT_EQ(command_->wheel_speed, 0.0);  // it does not repeat
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_layout_follower_nodelet");
  return RUN_ALL_TESTS();
}
