// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/laser_pose.hpp"

#include <gtest/gtest.h>
#include <tf2/exceptions.h>

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

class LaserPosesTest : public ::testing::Test {
 protected:
  void put(const Pose2& parent_T_child, double stamp, const char* parent, const char* child) {
    const auto message = to_transform(parent_T_child, Time(from_seconds(stamp)), parent, child);
    buffer_.setTransform(message.transforms[0], "test", stamp == 0.0);
  }
  static void expect_near(const Pose2& a, const Pose2& b) {
    EXPECT_LT((a.inverse() * b).log().norm(), 1e-9) << a << " " << b;
  }

  tf2::BufferCore buffer_;
  const Pose2 base_T_laser_{0.4, 0.1, 3.0};
};

TEST_F(LaserPosesTest, AreInterpolatedAtTheStamp) {
  put(base_T_laser_, 0.0, "base_link", "laser");
  put({1.0, 0.0, 0.0}, 10.0, "odom", "base_link");
  put({2.0, 0.0, 0.0}, 12.0, "odom", "base_link");
  const LaserPoses poses(buffer_, "odom", "base_link");
  expect_near(poses.at("laser", ros::Time(10.5)), Pose2(1.25, 0.0, 0.0) * base_T_laser_);
  expect_near(poses.mount("laser").base_T_laser, base_T_laser_);
  EXPECT_EQ(poses.mount("laser").upside_down, false);
  EXPECT_EQ(poses.frames(), (std::vector<std::string>{"odom", "base_link"}));
}

TEST_F(LaserPosesTest, OfALaserUpsideDownAreThoseOfAnUprightOne) {
  geometry_msgs::TransformStamped mount;
  mount.header.frame_id = "base_link";
  mount.child_frame_id = "laser";
  mount.transform.rotation.x = 1.0;
  buffer_.setTransform(mount, "test", true);
  put({1.0, 2.0, 0.5}, 10.0, "odom", "base_link");
  const LaserPoses poses(buffer_, "odom", "base_link");
  EXPECT_EQ(poses.mount("laser").upside_down, true);
  expect_near(poses.at("laser", ros::Time(10.0)), {1.0, 2.0, 0.5});
}

TEST_F(LaserPosesTest, WithoutABaseFrameAreThoseOfTheLaserAlone) {
  put({1.0, 2.0, 0.5}, 10.0, "odom", "laser");
  const LaserPoses poses(buffer_, "odom", "");
  expect_near(poses.at("laser", ros::Time(10.0)), {1.0, 2.0, 0.5});
  expect_near(poses.mount("laser").base_T_laser, {});
  EXPECT_FALSE(poses.mount("laser").upside_down);
  EXPECT_EQ(poses.frames(), std::vector<std::string>{"odom"});
}

TEST_F(LaserPosesTest, TellHowNewTheyAre) {
  const LaserPoses poses(buffer_, "odom", "base_link");
  EXPECT_FALSE(poses.newest("laser"));
  put(base_T_laser_, 0.0, "base_link", "laser");
  put({1.0, 0.0, 0.0}, 10.0, "odom", "base_link");
  put({2.0, 0.0, 0.0}, 12.0, "odom", "base_link");
  EXPECT_EQ(poses.newest("laser"), ros::Time(12.0));
  EXPECT_EQ(LaserPoses(buffer_, "odom", "").newest("laser"), ros::Time(12.0));
}

TEST_F(LaserPosesTest, DoNotMindALeadingSlash) {
  put(base_T_laser_, 0.0, "base_link", "laser");
  put({1.0, 0.0, 0.0}, 10.0, "odom", "base_link");
  const LaserPoses poses(buffer_, "/odom", "/base_link");
  expect_near(poses.at("/laser", ros::Time(10.0)), Pose2(1.0, 0.0, 0.0) * base_T_laser_);
  expect_near(poses.mount("/laser").base_T_laser, base_T_laser_);
  EXPECT_EQ(LaserPoses(buffer_, "/odom", "").newest("/laser"), ros::Time(10.0));
}

TEST_F(LaserPosesTest, ThrowWhereTfKnowsNoWay) {
  const LaserPoses poses(buffer_, "odom", "base_link");
  EXPECT_THROW(poses.mount("laser"), tf2::TransformException);
  put(base_T_laser_, 0.0, "base_link", "laser");
  put({1.0, 0.0, 0.0}, 10.0, "odom", "base_link");
  EXPECT_THROW(poses.at("laser", ros::Time(11.0)), tf2::TransformException);
  EXPECT_THROW(poses.at("other", ros::Time(10.0)), tf2::TransformException);
}

}  // namespace
}  // namespace falko_slam
