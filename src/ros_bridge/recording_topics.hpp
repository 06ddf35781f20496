// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <map>
#include <string>

namespace falko_slam {

/// Types of messages.
inline constexpr char kEncoderType[] = "falko_slam/TricycleEncoders";
inline constexpr char kOdometryType[] = "nav_msgs/Odometry";
inline constexpr char kReflectorType[] = "falko_slam/ReflectorArray";
inline constexpr char kScanType[] = "sensor_msgs/LaserScan";

/// By its ending; anything else is a CARMEN log.
bool is_bag(const std::string& path);

/// The bag's topic of LaserScan messages that is `wanted`, or the only one if that is empty. Throws
/// std::runtime_error that names the file (`path`) and the topics in it.
std::string scan_topic(const rosbag::Bag& bag, const std::string& path, const std::string& wanted);

/// Asked for, with or without its leading slash; where nothing is asked for, each.
bool is_wanted(const std::string& topic, const std::string& wanted);

/// The bag's topic of messages of this type that is `wanted`, or the only one if that is empty.
/// Throws std::runtime_error that names the file (`path`) and its topics with their types.
std::string topic_of_type(const rosbag::Bag& bag, const std::string& path, const std::string& type,
                          const std::string& wanted);

/// Type of the messages on each topic.
std::map<std::string, std::string> topic_types(const rosbag::Bag& bag);

/// "/scan (sensor_msgs/LaserScan), ..."; "no topics".
std::string describe(const std::map<std::string, std::string>& types);

}  // namespace falko_slam
