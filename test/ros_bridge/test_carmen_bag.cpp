// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/carmen_bag.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "support/bag_contents.hpp"
#include "support/carmen_lines.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using Names = std::vector<std::string>;

const std::vector<float> kRanges = {1.0F, 2.0F, 3.0F};
const Pose2 kMount(0.3, 0.0, 0.1);
const Pose2 kFirst(1.0, 2.0, 0.5);
const Pose2 kSecond(1.5, 2.0, 0.6);
const Pose2 kCorrected(-4.0, 5.0, 0.7);

// An odometry reading between two scans, and earlier than the first of them.
std::string small_log() {
  return test::vertex_line(0, kCorrected) +
         test::robotlaser_line(kRanges, kFirst * kMount, kFirst, 12.0) +
         test::odom_line(kSecond, 11.5) +
         test::robotlaser_line(kRanges, kSecond * kMount, kSecond, 12.5);
}

class ConvertCarmenLog : public ::testing::Test {
 protected:
  std::string convert(const std::string& text, const std::string& name = "test.log") {
    return convert_carmen_log(folder_.write(name, text), bag_, params_);
  }
  template <class Message>
  std::vector<Message> messages(const std::string& topic) const {
    return test::bag_messages_on<Message>(bag_, topic);
  }
  std::string error_of(const std::string& log) {
    try {
      convert_carmen_log(log, bag_, params_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  std::string bag_ = folder_.file("test.bag");
  CarmenBagParams params_;
};

TEST_F(ConvertCarmenLog, KeepsTheOrderOfTheLog) {
  convert(small_log());
  EXPECT_EQ(test::topics_in_order(test::bag_messages(bag_)),
            (Names{"/tf_static", "/tf", "/odom", "/ground_truth", "/scan",  // first scan
                   "/tf", "/odom",                                          // odometry
                   "/tf", "/odom", "/scan"}));
}

TEST_F(ConvertCarmenLog, StampsStayAndTheBagsTimeNeverRunsBack) {
  const std::string done = convert(small_log());
  const auto odometry = messages<nav_msgs::Odometry>("/odom");
  ASSERT_EQ(odometry.size(), 3U);
  EXPECT_EQ(odometry[0].header.stamp, ros::Time(12.0));
  EXPECT_EQ(odometry[1].header.stamp, ros::Time(11.5));
  const auto all = test::bag_messages(bag_);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(),
                             [](const auto& a, const auto& b) { return a.time < b.time; }));
  EXPECT_NEAR((all[5].time - ros::Time(12.0)).toSec(), 0.0, 1e-6);
  EXPECT_NE(done.find("1 stamps run backward"), std::string::npos) << done;
  EXPECT_NE(done.find("2 messages play later than their stamps say"), std::string::npos) << done;
}

TEST_F(ConvertCarmenLog, SaysNothingOfTimesWhereNoneIsMoved) {
  const std::string done = convert(test::odom_line(kFirst, 1.0) + test::odom_line(kSecond, 2.0));
  EXPECT_EQ(done.find("play later"), std::string::npos) << done;
  EXPECT_NE(done.find("2 odometry readings"), std::string::npos) << done;
}

TEST_F(ConvertCarmenLog, PutsPosesInTheirFrames) {
  params_.odom_frame = "o";
  params_.base_frame = "b";
  params_.laser_frame = "l";
  params_.map_frame = "m";
  convert(small_log());
  const auto odometry = messages<nav_msgs::Odometry>("/odom");
  EXPECT_EQ(odometry.at(0).header.frame_id, "o");
  EXPECT_EQ(odometry.at(0).child_frame_id, "b");
  EXPECT_NEAR(odometry[0].pose.pose.position.x, kFirst.x(), 1e-9);
  const auto truth = messages<geometry_msgs::PoseStamped>("/ground_truth");
  ASSERT_EQ(truth.size(), 1U);
  EXPECT_EQ(truth[0].header.frame_id, "m");
  EXPECT_EQ(truth[0].header.stamp, ros::Time(12.0));
  EXPECT_NEAR(truth[0].pose.position.x, kCorrected.x(), 1e-9);
  const auto scans = messages<sensor_msgs::LaserScan>("/scan");
  EXPECT_EQ(scans.at(0).header.frame_id, "l");
  EXPECT_EQ(scans.at(0).ranges, kRanges);
}

TEST_F(ConvertCarmenLog, TheMountIsAStaticTransform) {
  convert(small_log());
  const auto mounts = messages<tf2_msgs::TFMessage>("/tf_static");
  ASSERT_EQ(mounts.size(), 1U);
  const auto& mount = mounts[0].transforms.at(0);
  EXPECT_EQ(mount.header.frame_id, "base_link");
  EXPECT_EQ(mount.child_frame_id, "laser");
  EXPECT_NEAR(mount.transform.translation.x, kMount.x(), 1e-9);
  EXPECT_NEAR(mount.transform.translation.y, kMount.y(), 1e-9);
  EXPECT_NEAR(2.0 * std::asin(mount.transform.rotation.z), kMount.theta(), 1e-9);
}

TEST_F(ConvertCarmenLog, OdometryHasItsVelocities) {
  convert(test::odom_line(kFirst, 1.0));
  const auto odometry = messages<nav_msgs::Odometry>("/odom");
  ASSERT_EQ(odometry.size(), 1U);
  EXPECT_EQ(odometry[0].twist.twist.linear.x, 0.5);
  EXPECT_EQ(odometry[0].twist.twist.angular.z, 0.25);
  const auto transforms = messages<tf2_msgs::TFMessage>("/tf");
  ASSERT_EQ(transforms.size(), 1U);
  EXPECT_EQ(transforms[0].transforms.at(0).child_frame_id, "base_link");
}

TEST_F(ConvertCarmenLog, RefusesABagThatExists) {
  convert(small_log());
  EXPECT_EQ(error_of(folder_.file("test.log")), bag_ + ": exists already");
  params_.replace = true;
  EXPECT_EQ(error_of(folder_.file("test.log")), "no error");
}

TEST_F(ConvertCarmenLog, LeavesNothingBehindWhereThereIsNothingToConvert) {
  const std::string missing = error_of(folder_.file("missing.log"));
  EXPECT_NE(missing.find("missing.log: cannot be read"), std::string::npos) << missing;
  const std::string garbage = error_of(folder_.write("garbage.log", "no log\nat all\n"));
  EXPECT_NE(garbage.find("garbage.log: nothing to convert"), std::string::npos) << garbage;
  std::ofstream(folder_.file("packed.log.gz")) << "not packed at all";
  const std::string packed = error_of(folder_.file("packed.log.gz"));
  EXPECT_NE(packed.find("packed.log.gz: damaged"), std::string::npos) << packed;
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"garbage.log", "packed.log.gz"}));
}

}  // namespace
}  // namespace falko_slam
