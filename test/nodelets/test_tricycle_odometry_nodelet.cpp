// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <falko_slam/TricycleEncoders.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nodelet/loader.h>
#include <sensor_msgs/JointState.h>
#include <tf2_ros/transform_listener.h>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/vehicle/tricycle.hpp"
#include "spin_until.hpp"

namespace falko_slam {
namespace {

using test::spin_until;

constexpr std::uint32_t kSteer = 4000;  // of 65536
const double kSteering = 2.0 * M_PI * kSteer / 65536.0;

// Sends encoders of a namespace and hears its odometry.
template <class Message>
class OdometryClient : public ::testing::Test {
 protected:
  void connect(const std::string& name, const std::string& topic) {
    node_ = ros::NodeHandle(name);
    encoders_ = node_.advertise<Message>(topic, 100);
    odometry_ = node_.subscribe<nav_msgs::Odometry>(
        "odom", 100, [this](const auto& message) { heard_.push_back(*message); });
    ASSERT_TRUE(spin_until(
        [this] { return encoders_.getNumSubscribers() > 0 && odometry_.getNumPublishers() > 0; }));
  }
  // And waits for what comes of it.
  void send(const Message& message) {
    const std::size_t before = heard_.size();
    encoders_.publish(message);
    ASSERT_TRUE(spin_until([&] { return heard_.size() > before; }));
  }
  const nav_msgs::Odometry& last() const { return heard_.at(heard_.size() - 1); }

  ros::NodeHandle node_;
  ros::Publisher encoders_;
  ros::Subscriber odometry_;
  std::vector<nav_msgs::Odometry> heard_;
};

class WithCalibration : public OdometryClient<TricycleEncoders> {
 protected:
  void SetUp() override {
    connect("/", "encoders");
    start_ = end_of_others_ += ros::Duration(1000.0);
  }
  TricycleEncoders reading(double seconds, std::uint32_t ticks) const {
    return to_message({from_ros(start_ + ros::Duration(seconds)), ticks, kSteer}, "base_link");
  }
  static inline ros::Time end_of_others_{1000.0};
  ros::Time start_;
};

TEST_F(WithCalibration, DrivesTheCalibratedArcOverTheEndOfTheCounter) {
  send(reading(0.0, 4294967000U));
  const Pose2 before =
      Pose2(last().pose.pose.position.x, last().pose.pose.position.y,
            2.0 * std::atan2(last().pose.pose.orientation.z, last().pose.pose.orientation.w));
  send(reading(1.0, 704U));  // 1000 ticks on
  const TricycleParams calibrated{1.5, 2e-4, 0.05, -0.03};
  const Pose2 expected = before * drive_arc(calibrated, 1000.0, 1.1 * kSteering);
  EXPECT_NEAR(last().pose.pose.position.x, expected.x(), 1e-9);
  EXPECT_NEAR(last().pose.pose.position.y, expected.y(), 1e-9);
  EXPECT_NEAR(last().pose.pose.orientation.z, std::sin(0.5 * expected.theta()), 1e-9);
  EXPECT_NEAR(last().twist.twist.linear.x, 0.2 * std::cos(1.1 * kSteering + 0.05), 1e-9);
  EXPECT_NEAR(last().twist.twist.angular.z, 0.2 * std::sin(1.1 * kSteering + 0.05) / 1.5, 1e-9);
  EXPECT_EQ(last().header.frame_id, "odom");
  EXPECT_EQ(last().child_frame_id, "base_link");
  EXPECT_EQ(last().header.stamp, start_ + ros::Duration(1.0));
}

TEST_F(WithCalibration, KnowsLessTheFartherItHasDriven) {
  send(reading(0.0, 0));
  double before = -1.0;
  for (std::uint32_t i = 1; i < 5; ++i) {
    send(reading(0.1 * i, 500 * i));
    EXPECT_GT(last().pose.covariance[35], before);
    before = last().pose.covariance[35];
    EXPECT_GT(last().twist.covariance[0], 0.0);
  }
  send(reading(1.0, 2000));  // at rest
  EXPECT_EQ(last().pose.covariance[35], before);
}

TEST_F(WithCalibration, TellsTfWhereTheVehicleAndTheLaserAre) {
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  send(reading(0.0, 0));
  std::uint32_t sent = 0;
  ASSERT_TRUE(spin_until([&] {
    send(reading(0.1 * ++sent, 0));
    return buffer.canTransform("odom", "laser", ros::Time(0));
  }));
  const auto mount = buffer.lookupTransform("base_link", "laser", ros::Time(0)).transform;
  EXPECT_EQ(mount.translation.x, 0.4);
  EXPECT_EQ(mount.translation.y, 0.1);
  EXPECT_NEAR(in_plane(mount).theta(), 0.2, 1e-12);
}

TEST_F(WithCalibration, LeavesOutWhatComesLateAndGoesOnAfterTheClockWasSetBack) {
  send(reading(100.0, 0));
  send(reading(101.0, 1000));
  const double x = last().pose.pose.position.x, y = last().pose.pose.position.y;
  const std::size_t heard = heard_.size();
  encoders_.publish(reading(100.5, 500));
  encoders_.publish(reading(10.0, 1000));  // 91 s back
  send(reading(10.1, 1000));
  EXPECT_EQ(heard_.size(), heard + 1);
  EXPECT_EQ(last().pose.pose.position.x, x);
  EXPECT_EQ(last().pose.pose.position.y, y);
}

class OnJoints : public OdometryClient<sensor_msgs::JointState> {
 protected:
  void SetUp() override { connect("/joints", "joint_states"); }
  static sensor_msgs::JointState joints(double seconds, double turns) {
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time(1000.0 + seconds);
    message.name = {kDriveJoint, kSteerJoint};
    message.position = {2.0 * M_PI * turns, 0.0};
    return message;
  }
};

TEST_F(OnJoints, DrivesStraightAndIsNotFooledByAJumpOfTheCounter) {
  send(joints(0.0, 0.0));
  send(joints(1.0, 0.8));  // 4000 ticks of 0.25 mm
  EXPECT_NEAR(last().pose.pose.position.x, 1.0, 1e-9);
  EXPECT_EQ(last().header.frame_id, "joints_odom");
  EXPECT_EQ(last().child_frame_id, "joints_base");
  send(joints(2.0, 100.0));
  EXPECT_NEAR(last().pose.pose.position.x, 1.0, 1e-9);
  send(joints(3.0, 100.8));
  EXPECT_NEAR(last().pose.pose.position.x, 2.0, 1e-9);
}

TEST(TricycleOdometryNodelet, DoesNotLoadWithBadParametersOrWithoutItsFile) {
  ros::NodeHandle node("/refused");
  nodelet::Loader loader(false);
  node.setParam("vehicle/wheelbase", 0.0);
  EXPECT_FALSE(loader.load("/refused", "falko_slam/TricycleOdometry", {}, {}));
  node.setParam("vehicle/wheelbase", 1.0);
  node.setParam("vehicle/calibration_file", "/missing/calibration.yaml");
  EXPECT_FALSE(loader.load("/refused", "falko_slam/TricycleOdometry", {}, {}));
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_tricycle_odometry_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
