// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/pose_handover.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "falko_slam/ros_bridge/localizer_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {
namespace {

const Pose2 kMapPose(10.0, 5.0, 0.5 * M_PI);  // of the base when it is kept

// A vehicle of whose odometry a handover hears once a second.
class PoseHandoverTest : public ::testing::Test {
 protected:
  PoseHandoverTest() { hear(0.0, Pose2(1.0, 2.0, 0.0)); }

  static Time seconds(double time) {
    return Time(std::chrono::milliseconds(std::lround(1e3 * time)));
  }

  void hear(double time, const Pose2& odom_T_base) {
    const auto message = to_transform(odom_T_base, seconds(100.0 + time), "odom", "base_link");
    ASSERT_TRUE(transforms.setTransform(message.transforms[0], "test"));
  }

  void drive_to(double time, const Pose2& odom_T_base) {
    hear(time, odom_T_base);
    handover.follow();
  }

  // Straight on along x of odometry, a metre a second.
  void drive_straight(int metres) {
    for (int i = 1; i <= metres; ++i) drive_to(i, Pose2(1.0 + i, 2.0, 0.0));
  }

  static geometry_msgs::PoseWithCovarianceStamped map_pose(double time = 0.0) {
    return pose_message({kMapPose, pose_covariance(0.01, 0.002)}, seconds(100.0 + time), "map");
  }

  void keep(const geometry_msgs::PoseWithCovarianceStamped& pose = map_pose(), double age = 0.5) {
    handover.keep("hall.yaml", pose, pose.header.stamp + ros::Duration(age));
  }

  bool is_known() const { return handover.pose_on("hall.yaml").has_value(); }

  tf2::BufferCore transforms;
  PoseHandover handover{transforms, "odom", "base_link"};
};

TEST_F(PoseHandoverTest, KnowsNothingBeforeItKeepsAPose) {
  handover.follow();
  EXPECT_FALSE(is_known());
}

TEST_F(PoseHandoverTest, GoesOnWithOdometryAndIsLessSureAfterAWay) {
  keep();
  drive_straight(4);
  const auto pose = handover.pose_on("hall.yaml");
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->header.frame_id, "map");
  EXPECT_EQ(pose->header.stamp, ros::Time(104));
  const Pose2 map_T_base = in_plane(pose->pose.pose);
  EXPECT_NEAR(map_T_base.x(), 10.0, 1e-9);
  EXPECT_NEAR(map_T_base.y(), 9.0, 1e-9);
  EXPECT_NEAR(map_T_base.theta(), 0.5 * M_PI, 1e-9);
  // Along: what was and what odometry adds, .02 + 4 * .03. Across: the heading that was over 4 m,
  // too. Heading: .005 + 4 * .005.
  EXPECT_NEAR(pose->pose.covariance[7], 0.01 * 0.01 + 0.14 * 0.14, 1e-9);
  EXPECT_NEAR(pose->pose.covariance[0], 0.01 * 0.01 + 0.008 * 0.008 + 0.14 * 0.14, 1e-9);
  EXPECT_NEAR(pose->pose.covariance[35], 0.002 * 0.002 + 0.025 * 0.025, 1e-9);
}

TEST_F(PoseHandoverTest, CountsTheWayAndNotTheDistance) {
  keep();
  drive_to(1.0, Pose2(4.0, 2.0, 0.0));
  drive_to(2.0, Pose2(1.0, 2.0, 0.0));
  const auto pose = handover.pose_on("hall.yaml");
  ASSERT_TRUE(pose);
  EXPECT_NEAR((in_plane(pose->pose.pose).translation() - kMapPose.translation()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(pose->pose.covariance[7], 0.01 * 0.01 + 0.2 * 0.2, 1e-9);
}

TEST_F(PoseHandoverTest, IsOfOneMap) {
  keep();
  drive_straight(1);
  EXPECT_FALSE(handover.pose_on("yard.yaml"));
  EXPECT_TRUE(is_known());
}

TEST_F(PoseHandoverTest, GivesUpAfterALongWay) {
  keep();
  drive_straight(30);
  EXPECT_TRUE(is_known());
  drive_to(31.0, Pose2(32.0, 2.0, 0.0));
  EXPECT_FALSE(is_known());
}

TEST_F(PoseHandoverTest, AJumpIsAnotherOdometry) {
  keep();
  drive_to(1.0, Pose2(5.9, 2.0, 0.0));
  EXPECT_TRUE(is_known());
  drive_to(2.0, Pose2(0.8, 2.0, 0.0));
  EXPECT_FALSE(is_known());
  drive_to(3.0, Pose2(1.0, 2.0, 0.0));
  EXPECT_FALSE(is_known());  // it does not come back
}

TEST_F(PoseHandoverTest, AnOdometryThatBeginsAgainIsAnother) {
  keep();
  transforms.clear();
  drive_to(-10.0, Pose2(1.0, 2.0, 0.0));
  EXPECT_FALSE(is_known());
}

TEST_F(PoseHandoverTest, OdometryThatIsGoneTellsNothing) {
  keep();
  transforms.clear();
  handover.follow();
  EXPECT_FALSE(is_known());
}

TEST_F(PoseHandoverTest, KeepsNoOldPose) {
  keep(map_pose(), 1.9);
  EXPECT_TRUE(is_known());
  keep(map_pose(), 2.1);
  EXPECT_FALSE(is_known());  // nor the one before
}

TEST_F(PoseHandoverTest, KeepsNoPoseOfATimeWithoutOdometry) {
  hear(1.0, Pose2(2.0, 2.0, 0.0));
  keep(map_pose(0.5));
  EXPECT_TRUE(is_known());
  keep(map_pose(1.5));
  EXPECT_FALSE(is_known());
  keep(map_pose(-0.5));
  EXPECT_FALSE(is_known());
}

TEST_F(PoseHandoverTest, KeepsNoPoseThatCannotBeRead) {
  auto turned = map_pose();
  turned.pose.pose.orientation.w = std::numeric_limits<double>::quiet_NaN();
  keep(turned);
  EXPECT_FALSE(is_known());
  auto certain = map_pose();
  certain.pose.covariance[0] = -1.0;
  keep(certain);
  EXPECT_FALSE(is_known());
}

// What the ModeSwitch has before the Localizer said anything.
TEST_F(PoseHandoverTest, KeepsNoEmptyMessage) {
  handover.keep("hall.yaml", {}, ros::Time(100.5));
  EXPECT_FALSE(is_known());
}

}  // namespace
}  // namespace falko_slam
