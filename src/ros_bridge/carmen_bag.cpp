// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/carmen_bag.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
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
    nav_msgs::Odometry message = odometry_message(odometry.odom_T_robot, odometry.stamp);
    message.twist.twist.linear.x = odometry.forward_velocity;
    message.twist.twist.angular.z = odometry.turn_velocity;
    write_odometry(message, odometry.odom_T_robot, odometry.stamp);
  }

  // Written when the scan that follows gives it a stamp.
  void operator()(const CarmenVertex& vertex) { vertex_ = vertex; }

  void operator()(const CarmenScan& scan) {
    if (!mount_written_) write_mount(scan);
    write_odometry(odometry_message(scan.world_T_robot, scan.stamp), scan.world_T_robot,
                   scan.stamp);
    if (vertex_) write_ground_truth(vertex_->map_T_robot, scan.stamp);
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

  nav_msgs::Odometry odometry_message(const Pose2& odom_T_robot, Time stamp) const {
    nav_msgs::Odometry message;
    message.header.stamp = to_ros(stamp);
    message.header.frame_id = params_.odom_frame;
    message.child_frame_id = params_.base_frame;
    message.pose.pose = to_message(odom_T_robot);
    return message;
  }

  void write_odometry(const nav_msgs::Odometry& message, const Pose2& odom_T_robot, Time stamp) {
    bag_.write(topics::kTf, stamp,
               to_transform(odom_T_robot, stamp, params_.odom_frame, params_.base_frame));
    bag_.write(topics::kOdometry, stamp, message);
  }

  void write_ground_truth(const Pose2& map_T_robot, Time stamp) {
    geometry_msgs::PoseStamped message;
    message.header.stamp = to_ros(stamp);
    message.header.frame_id = params_.map_frame;
    message.pose = to_message(map_T_robot);
    bag_.write(topics::kGroundTruth, stamp, message);
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
