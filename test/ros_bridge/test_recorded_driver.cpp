// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/recorded_driver.hpp"

#include <falko_slam/DriveCommand.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <limits>

#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

constexpr Time kBegin{std::chrono::seconds(100)};

class RecordedDriver : public ::testing::Test {
 protected:
  template <class Message>
  void write(const std::string& topic, const std::vector<Message>& messages) {
    BagFile bag(path_, true);
    Time time = kBegin;
    for (const Message& message : messages) {
      bag.write(topic, time, message);
      time += std::chrono::milliseconds(20);
    }
    bag.finish();
  }
  std::string error(const std::string& topic = "") const {
    try {
      read_drive(path_, topic, {});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  bool complains(const std::string& words) const {
    return error().find(words) != std::string::npos;
  }

  static DriveCommand command(double wheel_speed) {
    DriveCommand message;
    message.header.stamp = ros::Time(100.0);
    message.wheel_speed = wheel_speed;
    return message;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("drive.bag");
};

TEST_F(RecordedDriver, ReadsEncodersWithTheirFirstCount) {
  write<TricycleEncoders>("encoders",
                          {to_message(EncoderReading{kBegin, 4294967290U, 3}, "base"),
                           to_message(EncoderReading{kBegin + from_seconds(0.1), 20, 3}, "base")});
  const RecordedDrive drive = read_drive(path_, "", {});
  EXPECT_EQ(drive.first_drive_ticks, 4294967290U);
  EXPECT_EQ(drive.description, "2 readings of encoders on /encoders");
}

TEST_F(RecordedDriver, NamesTheFileThatIsNotThere) {
  EXPECT_TRUE(complains("drive.bag")) << error();
}

TEST_F(RecordedDriver, ListsWhatTheBagHas) {
  write<std_msgs::String>("words", {std_msgs::String()});
  EXPECT_TRUE(
      complains("falko_slam/DriveCommand, falko_slam/TricycleEncoders, "
                "sensor_msgs/JointState; the bag has /words (std_msgs/String)"))
      << error();
}

TEST_F(RecordedDriver, NamesTheTopicThatWasAskedFor) {
  write<DriveCommand>("commands", {command(0.1)});
  EXPECT_EQ(error("commands"), "");
  EXPECT_NE(error("other").find("no drive on other"), std::string::npos) << error("other");
}

TEST_F(RecordedDriver, RefusesMessagesThatCannotBeUsed) {
  write<DriveCommand>("drive_command",
                      {command(0.1), command(std::numeric_limits<double>::quiet_NaN())});
  EXPECT_TRUE(complains("message 2 on /drive_command")) << error();
  DriveCommand without_stamp = command(0.1);
  without_stamp.header.stamp = ros::Time();
  write<DriveCommand>("drive_command", {without_stamp});
  EXPECT_TRUE(complains("it has no stamp")) << error();
  write<TricycleEncoders>("encoders", {to_message(EncoderReading{kBegin, 1, 3}, "base")});
  EXPECT_TRUE(complains("less than two readings")) << error();
  write<sensor_msgs::JointState>("joint_states", {sensor_msgs::JointState()});
  EXPECT_TRUE(complains("has no joints steer_joint and drive_joint")) << error();
}

}  // namespace
}  // namespace falko_slam
