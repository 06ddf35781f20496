// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <falko_slam/DriveCommand.h>
#include <falko_slam/ReflectorArray.h>
#include <falko_slam/TricycleEncoders.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>

#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/String.h>
#include <fstream>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/ros_bridge/bag_file.hpp"
#include "support/bag_contents.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using test::falko;

constexpr char kRoom[] = R"(name: room
world:
- wall: [[-5, -4], [9, -4], [9, 6], [-5, 6]]
  closed: true
- reflector: {at: [8, 2]}
vehicle:
  encoders: {steer_ticks_per_turn: 8192}
drive:
- arc: {wheel_speed: 0.5, steering: 0.4, turn: deg(40)}
- wait: {seconds: 0.5}
)";

class SimulateCommand : public ::testing::Test {
 protected:
  test::CommandResult simulate(const std::string& name, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"simulate", room_, "--out", folder_.file(name)};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }
  template <class Message>
  std::vector<Message> messages(const std::string& bag, const std::string& topic) const {
    return test::bag_messages_on<Message>(folder_.file(bag), topic);
  }

  test::TemporaryFolder folder_;
  std::string room_ = folder_.write("room.yaml", kRoom);
};

TEST_F(SimulateCommand, SameSeedSameBytes) {
  EXPECT_EQ(simulate("a.bag", {"--seed", "7"}).exit_code, 0);
  EXPECT_EQ(simulate("b.bag", {"--seed", "7"}).exit_code, 0);
  EXPECT_EQ(simulate("c.bag", {"--seed", "8"}).exit_code, 0);
  const std::string bytes = test::whole_file(folder_.file("a.bag"));
  EXPECT_FALSE(bytes.empty());
  EXPECT_TRUE(test::whole_file(folder_.file("b.bag")) == bytes);
  EXPECT_FALSE(test::whole_file(folder_.file("c.bag")) == bytes);
}

TEST_F(SimulateCommand, WritesScansAsTheSickDriverDoes) {
  const auto result = simulate("a.bag");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto scans = messages<sensor_msgs::LaserScan>("a.bag", "/scan");
  EXPECT_TRUE(result.says(std::to_string(scans.size()) + " scans of 1440 beams")) << result.output;
  ASSERT_GT(scans.size(), 20U);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const sensor_msgs::LaserScan& scan = scans[i];
    EXPECT_EQ(scan.header.frame_id, "laser");
    EXPECT_EQ(scan.header.stamp, ros::Time(1.0) + ros::Duration(0.125 * static_cast<double>(i)));
    EXPECT_FLOAT_EQ(scan.angle_min, static_cast<float>(-kPi));
    EXPECT_FLOAT_EQ(scan.angle_max, static_cast<float>(kPi));  // one past the last beam
    EXPECT_NEAR(scan.angle_increment, 0.00436332, 5e-9);
    EXPECT_FLOAT_EQ(scan.scan_time, 0.125F);
    EXPECT_FLOAT_EQ(scan.time_increment, 8.680556e-5F);
    EXPECT_FLOAT_EQ(scan.range_min, 0.05F);
    EXPECT_FLOAT_EQ(scan.range_max, 100.0F);
    EXPECT_EQ(scan.ranges.size(), 1440U);
    ASSERT_EQ(scan.intensities.size(), 1440U);
    for (const float intensity : scan.intensities) {
      ASSERT_EQ(intensity, std::round(intensity));
      ASSERT_LE(intensity, 65535.0F);
    }
  }
}

TEST_F(SimulateCommand, WritesWhatElseAVehicleTells) {
  ASSERT_EQ(simulate("a.bag").exit_code, 0);
  const auto encoders = messages<TricycleEncoders>("a.bag", "/encoders");
  const auto truth = messages<geometry_msgs::PoseStamped>("a.bag", "/ground_truth");
  const auto reflectors = messages<ReflectorArray>("a.bag", "/reflectors");
  const auto path = messages<nav_msgs::Path>("a.bag", "/ground_truth_path");

  ASSERT_EQ(encoders.size(), truth.size());
  EXPECT_GT(encoders.back().drive_ticks, encoders.front().drive_ticks);
  EXPECT_EQ(truth.back().header.frame_id, "world");
  EXPECT_NEAR(2.0 * std::asin(truth.back().pose.orientation.z), degrees_to_radians(40.0), 0.02);
  ASSERT_EQ(path.size(), 1U);
  EXPECT_GT(path[0].poses.size(), 10U);
  ASSERT_FALSE(reflectors.empty());
  ASSERT_EQ(reflectors[0].reflectors.size(), 1U);
  EXPECT_NEAR(reflectors[0].reflectors[0].position.x, 8.0 - 0.389, 0.05);
  EXPECT_EQ(reflectors[0].reflectors[0].global_id, Reflector::UNKNOWN_ID);
}

TEST_F(SimulateCommand, IsDrivenByRecordedEncoders) {
  ASSERT_EQ(simulate("first.bag").exit_code, 0);
  const auto result = simulate("again.bag", {"--drive", folder_.file("first.bag")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("readings of encoders on /encoders")) << result.output;
  const auto first = messages<TricycleEncoders>("first.bag", "/encoders");
  const auto again = messages<TricycleEncoders>("again.bag", "/encoders");
  EXPECT_EQ(again.back().drive_ticks, first.back().drive_ticks);
  EXPECT_EQ(again.back().steer_ticks, first.back().steer_ticks);
  const auto a = messages<geometry_msgs::PoseStamped>("first.bag", "/ground_truth").back().pose;
  const auto b = messages<geometry_msgs::PoseStamped>("again.bag", "/ground_truth").back().pose;
  EXPECT_NEAR(a.position.x, b.position.x, 0.01);
  EXPECT_NEAR(a.position.y, b.position.y, 0.01);
}

TEST_F(SimulateCommand, IsDrivenByRecordedJointStatesIfAsked) {
  ASSERT_EQ(simulate("first.bag").exit_code, 0);
  const auto result = simulate(
      "again.bag", {"--drive", folder_.file("first.bag"), "--drive-topic", "joint_states"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(messages<TricycleEncoders>("again.bag", "/encoders").back().drive_ticks,
            messages<TricycleEncoders>("first.bag", "/encoders").back().drive_ticks);
}

TEST_F(SimulateCommand, IsDrivenByRecordedCommands) {
  {
    BagFile bag(folder_.file("commands.bag"), false);
    for (int i = 0; i < 20; ++i) {
      DriveCommand command;
      command.header.stamp = ros::Time(50.0 + 0.1 * i);
      command.wheel_speed = -0.4;
      bag.write("drive_command", from_ros(command.header.stamp), command);
    }
    bag.finish();
  }
  const auto result = simulate("a.bag", {"--drive", folder_.file("commands.bag")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto truth = messages<geometry_msgs::PoseStamped>("a.bag", "/ground_truth");
  EXPECT_LT(truth.back().pose.position.x, -0.5);
}

TEST_F(SimulateCommand, ListsTheTopicsOfABagThatHasNoDrive) {
  {
    BagFile bag(folder_.file("words.bag"), false);
    bag.write("words", Time(std::chrono::seconds(5)), std_msgs::String());
    bag.finish();
  }
  const auto result = simulate("a.bag", {"--drive", folder_.file("words.bag")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("words.bag: no drive")) << result.errors;
  EXPECT_TRUE(result.complains("falko_slam/TricycleEncoders")) << result.errors;
  EXPECT_TRUE(result.complains("/words (std_msgs/String)")) << result.errors;
  EXPECT_FALSE(std::ifstream(folder_.file("a.bag")).is_open());
}

TEST_F(SimulateCommand, StandsForAsLongAsItIsTold) {
  ASSERT_EQ(simulate("a.bag", {"--duration", "1"}).exit_code, 0);
  EXPECT_EQ(messages<TricycleEncoders>("a.bag", "/encoders").size(), 51U);
}

TEST_F(SimulateCommand, NamesFileLineAndKeyOfABadScenario) {
  room_ = folder_.write("bad.yaml", "world:\n- box: {at: [1, 2], size: [1, -2]}\n");
  const auto result = simulate("a.bag");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("bad.yaml: line 2: world[0].box.size")) << result.errors;
  EXPECT_FALSE(std::ifstream(folder_.file("a.bag")).is_open());
}

TEST_F(SimulateCommand, WritesTheTruthOfEachScan) {
  ASSERT_EQ(simulate("a.bag", {"--truth", folder_.file("truth.tum")}).exit_code, 0);
  const auto scans = messages<sensor_msgs::LaserScan>("a.bag", "/scan");
  const Trajectory truth = read_tum(folder_.file("truth.tum"));
  ASSERT_EQ(truth.size(), scans.size());
  EXPECT_EQ(truth.back().stamp, from_ros(scans.back().header.stamp));
  EXPECT_EQ(truth.front().map_T_base.translation().norm(), 0.0);
}

TEST_F(SimulateCommand, NeedsADrive) {
  room_ = folder_.write("still.yaml", "world:\n- box: {at: [3, 2], size: [1, 2]}\n");
  EXPECT_TRUE(simulate("a.bag").complains("has no drive"));
}

TEST_F(SimulateCommand, ReplacesABagOnlyIfTold) {
  simulate("a.bag", {"--seed", "1"});
  const std::string before = test::whole_file(folder_.file("a.bag"));
  const auto refused = simulate("a.bag", {"--seed", "2"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.errors,
            "falko: " + folder_.file("a.bag") + ": exists already; --force replaces it\n");
  EXPECT_TRUE(test::whole_file(folder_.file("a.bag")) == before);
  EXPECT_EQ(simulate("a.bag", {"--seed", "2", "--force"}).exit_code, 0);
  EXPECT_FALSE(test::whole_file(folder_.file("a.bag")) == before);
}

}  // namespace
}  // namespace falko_slam
