// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/carmen_bag.hpp"

#include <sensor_msgs/LaserScan.h>

#include <stdexcept>
#include <variant>

#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/sensor/carmen_log.hpp"

namespace falko_slam {
namespace {

class CarmenBagWriter {
 public:
  CarmenBagWriter(BagFile& bag, const CarmenBagParams& params) : bag_(bag), params_(params) {}

  void operator()(const CarmenOdometry& odometry) {
    nav_msgs::Odometry message = odometry_at(odometry.odom_T_robot, odometry.stamp);
    message.twist.twist.linear.x = odometry.forward_velocity;
    message.twist.twist.angular.z = odometry.turn_velocity;
    write_odometry(message, odometry.odom_T_robot, odometry.stamp);
  }

  // Written when the scan that follows gives it a stamp.
  void operator()(const CarmenVertex& vertex) { vertex_ = vertex; }

  void operator()(const CarmenScan& scan) {
    if (!mount_written_) write_mount(scan);
    write_odometry(odometry_at(scan.world_T_robot, scan.stamp), scan.world_T_robot, scan.stamp);
    if (vertex_) {
      bag_.write(topics::kGroundTruth, scan.stamp,
                 stamped_pose(vertex_->map_T_robot, scan.stamp, params_.map_frame));
    }
    vertex_.reset();
    bag_.write(topics::kScan, scan.stamp, to_message(scan.raw(), params_.laser_frame));
  }

 private:
  void write_mount(const CarmenScan& scan) {
    const Pose2 robot_T_laser = scan.world_T_robot.inverse() * scan.world_T_laser;
    bag_.write_latched(
        topics::kTfStatic, scan.stamp,
        to_transform(robot_T_laser, scan.stamp, params_.base_frame, params_.laser_frame));
    mount_written_ = true;
  }

  nav_msgs::Odometry odometry_at(const Pose2& odom_T_robot, Time stamp) const {
    return odometry_message(odom_T_robot, stamp, params_.odom_frame, params_.base_frame);
  }

  void write_odometry(const nav_msgs::Odometry& message, const Pose2& odom_T_robot, Time stamp) {
    bag_.write(topics::kTf, stamp,
               to_transform(odom_T_robot, stamp, params_.odom_frame, params_.base_frame));
    bag_.write(topics::kOdometry, stamp, message);
  }

  BagFile& bag_;
  const CarmenBagParams& params_;
  std::optional<CarmenVertex> vertex_;
  bool mount_written_ = false;
};

}  // namespace

std::string convert_carmen_log(const std::string& log, const std::string& bag,
                               const CarmenBagParams& params) {
  CarmenLogReader reader(log);
  BagFile file(bag, params.replace);
  CarmenBagWriter writer(file, params);
  while (const auto record = reader.next()) std::visit(writer, *record);
  const std::string done = describe(reader.report());
  if (reader.report().scans + reader.report().odometry == 0) {
    throw std::runtime_error(log + ": nothing to convert in " + done);
  }
  file.finish();
  return done + file.describe_moved_times();
}

}  // namespace falko_slam
