// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_listener.h>

#include <functional>
#include <memory>
#include <string>

#include "falko_slam/ros_bridge/laser_pose.hpp"

namespace falko_slam {

/// Hands scans on as soon as tf knows where the laser was: a tf2_ros::MessageFilter that loses
/// none, and that lives through jumps of time.
///
/// tf2_ros asks for the transforms of a message before it notes that the message waits; a transform
/// that comes in between, by the listener's thread, finds nobody waiting, and the message is never
/// handed on. Here one thread takes transforms and scans, one after the other.
class ScanFilter {
 public:
  using Message = sensor_msgs::LaserScanConstPtr;
  struct Listener {
    std::function<void(const Message&)> placed;
    /// What tf lacks for a scan.
    std::function<void(const Message&, const std::string& missing)> dropped;
  };
  /// At most `waiting` scans wait. The listener is called from the node's queue.
  ScanFilter(const ros::NodeHandle& node, const std::string& odom_frame,
             const std::string& base_frame, std::uint32_t waiting, Listener listener);
  ~ScanFilter();

  /// Drops what cannot be placed, or was pushed out by newer ones.
  void add(const Message& message);

  /// By how much time has jumped back since the last call [s]; 0 if it has not. What waits for
  /// transforms of the time before is forgotten. To be called now and then, also without scans.
  double watch_time();

  const LaserPoses& poses() const { return poses_; }

 private:
  using Filter = tf2_ros::MessageFilter<sensor_msgs::LaserScan>;

  void in_transform_thread(std::function<void()> action);
  void on_dropped(const Message& message);
  /// For some seconds after a jump of time: tf that was on its way comes after the buffer has been
  /// cleared, and makes it refuse all that follows as too old.
  void forget_the_future();

  Listener listener_;
  std::string last_frame_;  // of a laser
  ros::Time last_time_;
  double jumped_ = -1e9;  // when time did, steady clock [s]

  tf2_ros::Buffer buffer_{ros::Duration(120.0)};  // recordings are played fast
  LaserPoses poses_;
  ros::CallbackQueue queue_;
  std::unique_ptr<tf2_ros::TransformListener> transforms_;
  std::unique_ptr<Filter> filter_;
  ros::AsyncSpinner thread_{1, &queue_};
};

}  // namespace falko_slam
