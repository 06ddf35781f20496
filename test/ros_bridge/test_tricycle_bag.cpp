// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/tricycle_bag.hpp"

#include <falko_slam/TricycleEncoders.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/bag_contents.hpp"
#include "support/temporary_folder.hpp"
#include "support/tricycle_lines.hpp"

namespace falko_slam {
namespace {

using Names = std::vector<std::string>;

class ConvertTricycleLog : public ::testing::Test {
 protected:
  std::string convert(const std::string& text) {
    return convert_tricycle_log(folder_.write("test.log", text), bag_, params_);
  }
  template <class Message>
  std::vector<Message> messages(const std::string& topic) const {
    return test::bag_messages_on<Message>(bag_, topic);
  }
  std::string error_of(const std::string& text) {
    try {
      convert(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  std::string bag_ = folder_.file("test.bag");
  TricycleBagParams params_;
};

TEST_F(ConvertTricycleLog, WritesEveryRecordOnAllTopics) {
  const std::string done = convert(test::small_tricycle_log());
  Names expected = {"/tf_static"};
  for (int i = 0; i < 3; ++i) {
    for (const char* topic : {"/tf", "/odom", "/ground_truth", "/joint_states", "/encoders"}) {
      expected.push_back(topic);
    }
  }
  EXPECT_EQ(test::topics_in_order(test::bag_messages(bag_)), expected);
  EXPECT_EQ(done.find("11 lines: 3 encoder readings with poses, 8 others\nnominal values: "), 0U)
      << done;
  EXPECT_NE(done.find("wheelbase 1.4 m"), std::string::npos) << done;
}

TEST_F(ConvertTricycleLog, CountersAreAsRecorded) {
  convert(test::small_tricycle_log());
  const auto encoders = messages<TricycleEncoders>("/encoders");
  ASSERT_EQ(encoders.size(), 3U);
  EXPECT_EQ(encoders[0].header.stamp, ros::Time(1668091584, 821040869));
  EXPECT_EQ(encoders[0].header.frame_id, "base_link");
  EXPECT_EQ(encoders[0].drive_ticks, 4294967290U);
  EXPECT_EQ(encoders[1].drive_ticks, 4U);
  EXPECT_EQ(encoders[2].steer_ticks, 8000U);
}

TEST_F(ConvertTricycleLog, JointsFollowTheGainsOfTheHeader) {
  convert(test::small_tricycle_log());
  const auto joints = messages<sensor_msgs::JointState>("/joint_states");
  ASSERT_EQ(joints.size(), 3U);
  EXPECT_NEAR(joints[0].position.at(0), 0.1 * kTwoPi * 290.0 / 8192.0, 1e-12);
  EXPECT_NEAR(joints[1].position.at(0), -0.1 * kTwoPi * 2.0 / 8192.0, 1e-12);
  EXPECT_NEAR(joints[1].position.at(1) - joints[0].position.at(1), kTwoPi * 10.0 / 5000.0, 1e-8);
  EXPECT_NEAR(joints[2].position.at(1) - joints[1].position.at(1), -kTwoPi * 2.0 / 5000.0, 1e-8);
}

TEST_F(ConvertTricycleLog, PutsPosesInTheirFrames) {
  params_.odom_frame = "o";
  params_.base_frame = "b";
  params_.tracker_frame = "t";
  convert(test::small_tricycle_log());
  const auto odometry = messages<nav_msgs::Odometry>("/odom");
  ASSERT_EQ(odometry.size(), 3U);
  EXPECT_EQ(odometry[1].header.frame_id, "o");
  EXPECT_EQ(odometry[1].child_frame_id, "b");
  EXPECT_NEAR(odometry[1].pose.pose.position.x, 0.002, 1e-12);
  const auto transforms = messages<tf2_msgs::TFMessage>("/tf");
  ASSERT_EQ(transforms.size(), 3U);
  EXPECT_EQ(transforms[1].transforms.at(0).header.frame_id, "o");
  EXPECT_EQ(transforms[1].transforms[0].child_frame_id, "b");
  EXPECT_NEAR(transforms[1].transforms[0].transform.translation.x, 0.002, 1e-12);
  const auto truth = messages<geometry_msgs::PoseStamped>("/ground_truth");
  ASSERT_EQ(truth.size(), 3U);
  EXPECT_EQ(truth[2].header.frame_id, "t");
  EXPECT_NEAR(truth[2].pose.position.y, 1.0, 1e-12);
}

// It is not the base's pose in the map, and no frame of either may be taken for it.
TEST_F(ConvertTricycleLog, TheTruthIsThatOfTheLaserInItsFirstFrame) {
  convert(test::small_tricycle_log());
  for (const auto& pose : messages<geometry_msgs::PoseStamped>("/ground_truth")) {
    EXPECT_EQ(pose.header.frame_id, "laser_start");
  }
}

TEST_F(ConvertTricycleLog, TheMountIsALatchedStaticTransform) {
  convert(test::small_tricycle_log());
  const auto mounts = messages<tf2_msgs::TFMessage>("/tf_static");
  ASSERT_EQ(mounts.size(), 1U);
  const auto& mount = mounts[0].transforms.at(0);
  EXPECT_EQ(mount.header.frame_id, "base_link");
  EXPECT_EQ(mount.child_frame_id, "laser");
  EXPECT_NEAR(mount.transform.translation.x, 1.5, 1e-12);
  EXPECT_NEAR(mount.transform.translation.y, 0.25, 1e-12);
  EXPECT_NEAR(mount.transform.rotation.z, std::sin(kPi / 4.0), 1e-12);
  rosbag::Bag bag(bag_);
  rosbag::View view(bag, rosbag::TopicQuery("/tf_static"));
  for (const rosbag::MessageInstance& instance : view) EXPECT_TRUE(instance.isLatching());
}

TEST_F(ConvertTricycleLog, StampsStayAndTheBagsTimeNeverRunsBack) {
  const std::string done =
      convert(test::tricycle_header() + test::tricycle_line("12", "1 1", "0 0 0", "0 0 0") +
              test::tricycle_line("11.5", "1 1", "0 0 0", "0 0 0"));
  const auto encoders = messages<TricycleEncoders>("/encoders");
  ASSERT_EQ(encoders.size(), 2U);
  EXPECT_EQ(encoders[1].header.stamp, ros::Time(11.5));
  const auto all = test::bag_messages(bag_);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(),
                             [](const auto& a, const auto& b) { return a.time < b.time; }));
  EXPECT_NE(done.find("1 stamps run backward"), std::string::npos) << done;
  EXPECT_NE(done.find("5 messages play later than their stamps say"), std::string::npos) << done;
}

TEST_F(ConvertTricycleLog, LeavesNothingBehindWhereThereIsNothingToConvert) {
  const std::string log = folder_.file("test.log");
  EXPECT_EQ(error_of(test::tricycle_header()).find(log + ": nothing to convert in 8 lines"), 0U);
  EXPECT_EQ(error_of("no log\n").find(log + ": no tricycle log: its header has no"), 0U);
  std::string geared_up = test::small_tricycle_log();
  geared_up.replace(geared_up.find("0.1 1.0"), 3, "2.5");
  EXPECT_EQ(error_of(geared_up).find(log + ": its header: steer_gain = 2.5:"), 0U);
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"test.log"}));
}

TEST_F(ConvertTricycleLog, RefusesABagThatExists) {
  convert(test::small_tricycle_log());
  EXPECT_EQ(error_of(test::small_tricycle_log()), bag_ + ": exists already");
  params_.replace = true;
  EXPECT_EQ(error_of(test::small_tricycle_log()), "no error");
}

}  // namespace
}  // namespace falko_slam
