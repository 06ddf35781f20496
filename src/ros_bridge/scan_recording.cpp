// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_recording.hpp"

#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <set>
#include <stdexcept>
#include <variant>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/sensor/carmen_log.hpp"

namespace falko_slam {
namespace {

bool is_bag(const std::string& path) {
  const std::string ending = ".bag";
  return path.size() > ending.size() &&
         path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

std::string scan_topic(const rosbag::Bag& bag, const std::string& path, const std::string& wanted) {
  std::set<std::string> scans;
  std::set<std::string> all;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    all.insert(connection->topic);
    if (connection->datatype == "sensor_msgs/LaserScan") scans.insert(connection->topic);
  }
  if (wanted.empty() && scans.size() == 1) return *scans.begin();
  for (const std::string& name : {wanted, "/" + wanted}) {
    if (scans.count(name) > 0) return name;
  }
  throw std::runtime_error(path + ": " +
                           (wanted.empty() ? "which scans? " : "no LaserScan on " + wanted + ". ") +
                           "LaserScan topics: " + joined(scans) + "; all topics: " + joined(all));
}

std::string read_bag(const std::string& path, const std::string& wanted,
                     const std::function<void(const RawScan&)>& use) {
  try {
    rosbag::Bag bag(path);
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
  return is_bag(path) ? read_bag(path, topic, use) : read_log(path, use);
}

}  // namespace falko_slam
