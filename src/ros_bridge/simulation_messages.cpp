// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/simulation_messages.hpp"

#include <cmath>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

Reflector to_message(const ReflectorDetection& found, std::size_t number, double diameter) {
  Reflector message;
  message.position.x = found.range * std::cos(found.bearing);
  message.position.y = found.range * std::sin(found.bearing);
  message.range = found.range;
  message.bearing = found.bearing;
  message.local_id = static_cast<std::uint16_t>(number);
  message.global_id = Reflector::UNKNOWN_ID;
  message.diameter = diameter;
  message.hit_count = static_cast<std::uint16_t>(found.hits);
  message.mean_echo = found.mean_intensity;
  message.start_index = static_cast<std::uint32_t>(found.first_beam);
  message.end_index = static_cast<std::uint32_t>(found.last_beam);
  message.time_offset = to_ros(from_seconds(found.time_offset));
  return message;
}

}  // namespace

SimulationMessenger::SimulationMessenger(const Scenario& scenario, const SimulationFrames& frames)
    : laser_(scenario.laser),
      base_T_laser_(scenario.vehicle.nominal_base_T_laser),
      reflector_diameter_(diameter_of_reflectors(scenario.world)),
      frames_(frames),
      odometry_(scenario.vehicle.nominal, scenario.vehicle.encoders),
      joints_(JointParams{scenario.vehicle.encoders}) {}

tf2_msgs::TFMessage SimulationMessenger::mount(Time stamp) const {
  return to_transform(base_T_laser_, stamp, frames_.base, frames_.laser);
}

ReflectorArray SimulationMessenger::reflectors_of(const SimulationStep::Scan& scan) const {
  ReflectorArray message;
  message.header = header_of(scan.scan.first_beam, frames_.laser);
  for (const ReflectorDetection& found : scan.reflectors) {
    message.reflectors.push_back(to_message(found, message.reflectors.size(), reflector_diameter_));
  }
  return message;
}

void SimulationMessenger::add_odometry(const SimulationStep& step, SimulationMessages& messages) {
  odometry_.add(step.encoders);
  messages.odometry =
      odometry_message(odometry_.odom_T_base(), step.encoders.stamp, frames_.odom, frames_.base);
  messages.odometry.twist.twist.linear.x = odometry_.velocity().forward;
  messages.odometry.twist.twist.angular.z = odometry_.velocity().turn_rate;
  messages.odom_T_base =
      to_transform(odometry_.odom_T_base(), step.encoders.stamp, frames_.odom, frames_.base);
}

SimulationMessages SimulationMessenger::of(const SimulationStep& step) {
  SimulationMessages messages;
  for (const SimulationStep::Scan& scan : step.scans) {
    messages.scans.push_back(falko_slam::to_message(as_raw_scan(laser_, scan.scan), frames_.laser));
    if (laser_.intensities) messages.reflectors.push_back(reflectors_of(scan));
  }
  messages.encoders = falko_slam::to_message(step.encoders, frames_.base);
  messages.joints = joints_.next(step.encoders);
  add_odometry(step, messages);
  messages.truth = stamped_pose(step.world_T_base, step.encoders.stamp, frames_.world);
  messages.world_T_odom = to_transform(step.world_T_base * odometry_.odom_T_base().inverse(),
                                       step.encoders.stamp, frames_.world, frames_.odom);
  return messages;
}

void extend_path(nav_msgs::Path& path, const geometry_msgs::PoseStamped& pose) {
  constexpr double kStep = 0.1;  // [m]
  if (!path.poses.empty()) {
    const geometry_msgs::Point& last = path.poses.back().pose.position;
    const geometry_msgs::Point& here = pose.pose.position;
    if (std::hypot(here.x - last.x, here.y - last.y) < kStep) return;
  }
  path.poses.push_back(pose);
}

}  // namespace falko_slam
