// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/recorded_driver.hpp"

#include <falko_slam/DriveCommand.h>
#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
namespace {

// The bag of a drive, one topic of it.
struct Recorded {
  const rosbag::Bag& bag;
  std::string topic;

  template <class Message, class Use>
  std::size_t for_each(const Use& use) const {
    std::size_t count = 0;
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) {
      const auto message = instance.instantiate<Message>();
      if (!message) continue;
      ++count;
      try {
        use(*message);
      } catch (const std::invalid_argument& error) {
        throw std::runtime_error("message " + std::to_string(count) + " on " + topic + ": " +
                                 error.what());
      }
    }
    return count;
  }
};

Time stamp_of(const std_msgs::Header& header) {
  if (header.stamp.isZero()) throw std::invalid_argument("it has no stamp");
  return from_ros(header.stamp);
}

RecordedDrive read_commands(const Recorded& recorded, const VehicleModel& vehicle) {
  std::vector<std::pair<Time, WheelCommand>> commands;
  recorded.for_each<DriveCommand>([&](const DriveCommand& message) {
    if (!std::isfinite(message.wheel_speed) || !std::isfinite(message.steering)) {
      throw std::invalid_argument("a command that is not finite");
    }
    commands.push_back({stamp_of(message.header), {message.wheel_speed, message.steering}});
  });
  const std::string count = std::to_string(commands.size());
  RecordedDrive drive;
  drive.driver =
      recorded_commands(std::move(commands), from_seconds(vehicle.actuators.command_timeout));
  drive.description = count + " commands on " + recorded.topic;
  return drive;
}

RecordedDrive drive_of(std::vector<EncoderReading> readings, const Recorded& recorded,
                       const VehicleModel& vehicle) {
  if (readings.size() < 2) {
    throw std::runtime_error(recorded.topic + " has less than two readings");
  }
  RecordedDrive drive;
  drive.first_drive_ticks = readings.front().drive_ticks;
  drive.description =
      std::to_string(readings.size()) + " readings of encoders on " + recorded.topic;
  drive.driver = recorded_encoders(std::move(readings), vehicle.encoders);
  return drive;
}

RecordedDrive read_encoders(const Recorded& recorded, const VehicleModel& vehicle) {
  std::vector<EncoderReading> readings;
  recorded.for_each<TricycleEncoders>([&](const TricycleEncoders& message) {
    stamp_of(message.header);
    readings.push_back(from_message(message));
  });
  return drive_of(std::move(readings), recorded, vehicle);
}

// States of other joints may come on the same topic.
RecordedDrive read_joints(const Recorded& recorded, const VehicleModel& vehicle) {
  std::vector<EncoderReading> readings;
  const JointParams params{vehicle.encoders};
  recorded.for_each<sensor_msgs::JointState>([&](const sensor_msgs::JointState& message) {
    if (const auto reading = from_message(message, params)) readings.push_back(*reading);
  });
  if (readings.empty()) {
    throw std::runtime_error(recorded.topic + " has no joints " + kSteerJoint + " and " +
                             kDriveJoint);
  }
  return drive_of(std::move(readings), recorded, vehicle);
}

struct Kind {
  const char* type;
  RecordedDrive (*read)(const Recorded&, const VehicleModel&);
};
constexpr Kind kKinds[] = {{"falko_slam/DriveCommand", read_commands},
                           {kEncoderType, read_encoders},
                           {"sensor_msgs/JointState", read_joints}};

RecordedDrive read(const rosbag::Bag& bag, const std::string& path, const std::string& wanted,
                   const VehicleModel& vehicle) {
  const auto types = topic_types(bag);
  std::string needed;
  for (const Kind& kind : kKinds) {
    const bool there = std::any_of(types.begin(), types.end(), [&](const auto& topic) {
      return topic.second == kind.type && is_wanted(topic.first, wanted);
    });
    if (there) return kind.read({bag, topic_of_type(bag, path, kind.type, wanted)}, vehicle);
    needed += (needed.empty() ? "" : ", ") + std::string(kind.type);
  }
  throw std::runtime_error(path + ": no drive" + (wanted.empty() ? "" : " on " + wanted) +
                           ": needs a topic of " + needed + "; the bag has " + describe(types));
}

}  // namespace

RecordedDrive read_drive(const std::string& bag, const std::string& topic,
                         const VehicleModel& vehicle) {
  try {
    return read(rosbag::Bag(bag), bag, topic, vehicle);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(bag + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(bag + ": " + error.what());
  }
}

}  // namespace falko_slam
