// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_recording.hpp"

#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <stdexcept>
#include <variant>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/sensor/carmen_log.hpp"
#include "packed_bag.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
namespace {

// `path`: as it stands in messages.
std::string read_bag(const std::string& file, const std::string& path, const std::string& wanted,
                     const std::function<void(const RawScan&)>& use) {
  try {
    rosbag::Bag bag(file);
    const std::string topic = scan_topic(bag, path, wanted);
    std::size_t count = 0;
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) {
      const auto message = instance.instantiate<sensor_msgs::LaserScan>();
      if (!message) continue;
      use(as_raw_scan(*message));
      ++count;
    }
    if (count == 0) throw std::runtime_error(path + ": no laser scan on " + topic);
    return std::to_string(count) + " scans on " + topic;
  } catch (const ros::Exception& error) {  // of the bag or of a message in it
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::string read_log(const std::string& path, const std::function<void(const RawScan&)>& use) {
  CarmenLogReader reader(path);
  while (const auto record = reader.next()) {
    if (const auto* scan = std::get_if<CarmenScan>(&*record)) use(scan->raw());
  }
  std::string read = describe(reader.report());
  if (reader.report().scans == 0) throw std::runtime_error(path + ": no laser scan in " + read);
  return read;
}

}  // namespace

std::string read_scans(const std::string& path, const std::string& topic,
                       const std::function<void(const RawScan&)>& use) {
  if (is_packed_bag(path)) {
    const UnpackedBag unpacked(path);
    return read_bag(unpacked.path(), path, topic, use);
  }
  return is_bag(path) ? read_bag(path, path, topic, use) : read_log(path, use);
}

}  // namespace falko_slam
