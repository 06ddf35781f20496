// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"

#include <cmath>
#include <limits>

#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

float range_of(const LaserScan& scan, std::size_t beam) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  switch (scan.status[beam]) {
    case BeamStatus::kValid:
      return static_cast<float>(scan.ranges[beam]);
    case BeamStatus::kNoReturn:
    case BeamStatus::kTooFar:
      return kInfinity;
    case BeamStatus::kTooNear:
      return -kInfinity;
    case BeamStatus::kZero:
      return 0.0F;
    case BeamStatus::kErroneous:
      break;
  }
  return std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

RawScan as_raw_scan(const sensor_msgs::LaserScan& message) {
  RawScan raw;
  raw.stamp = from_ros(message.header.stamp);
  raw.angle_min = static_cast<double>(message.angle_min);
  raw.angle_max = static_cast<double>(message.angle_max);
  raw.angle_increment = static_cast<double>(message.angle_increment);
  raw.time_increment = static_cast<double>(message.time_increment);
  raw.scan_time = static_cast<double>(message.scan_time);
  raw.range_min = static_cast<double>(message.range_min);
  raw.range_max = static_cast<double>(message.range_max);
  raw.ranges = message.ranges.data();
  raw.range_count = message.ranges.size();
  raw.intensities = message.intensities.data();
  raw.intensity_count = message.intensities.size();
  return raw;
}

sensor_msgs::LaserScan to_message(const RawScan& raw, const std::string& frame) {
  sensor_msgs::LaserScan message;
  message.header.stamp = to_ros(raw.stamp);
  message.header.frame_id = frame;
  message.angle_min = static_cast<float>(raw.angle_min);
  message.angle_max = static_cast<float>(raw.angle_max);
  message.angle_increment = static_cast<float>(raw.angle_increment);
  message.time_increment = static_cast<float>(raw.time_increment);
  message.scan_time = static_cast<float>(raw.scan_time);
  message.range_min = static_cast<float>(raw.range_min);
  message.range_max = static_cast<float>(raw.range_max);
  message.ranges.assign(raw.ranges, raw.ranges + raw.range_count);
  message.intensities.assign(raw.intensities, raw.intensities + raw.intensity_count);
  return message;
}

sensor_msgs::LaserScan to_message(const LaserScan& scan, Time stamp) {
  sensor_msgs::LaserScan message;
  message.header.stamp = to_ros(stamp);
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  if (scan.size() > 0) message.angle_max = static_cast<float>(scan.bearing(scan.size() - 1));
  message.time_increment = static_cast<float>(to_seconds(scan.time_increment));
  message.scan_time = std::abs(message.time_increment) * static_cast<float>(scan.size());
  message.range_max = static_cast<float>(scan.range_max);
  for (std::size_t beam = 0; beam < scan.size(); ++beam) {
    message.ranges.push_back(range_of(scan, beam));
  }
  return message;
}

}  // namespace falko_slam
