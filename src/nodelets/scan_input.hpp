// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_listener.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

struct ScanInputParams {
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  bool use_odometry = true;
  ScanNormalizerParams scan;
};

/// Takes scans from `scan` and their poses from tf. Calls come from the node handle's queue.
class ScanInput {
 public:
  struct Listener {
    std::function<void(const ScanReport&)> received;      ///< every scan
    std::function<void(const std::string&)> dropped;      ///< what tf lacks for a scan
    std::function<void(SlamScan)> placed;                 ///< a scan with a valid beam and its pose
    std::function<void(double seconds)> time_has_jumped;  ///< back by so much
  };
  ScanInput(const ros::NodeHandle& node, const ScanInputParams& params, Listener listener);
  ~ScanInput();

  /// To be called now and then, for times without scans.
  void watch_time();

 private:
  using Message = sensor_msgs::LaserScanConstPtr;
  void connect(ros::NodeHandle node);
  void on_received(const Message& message);
  void on_placed(const Message& message);
  void on_dropped(const Message& message);
  /// For some seconds after a jump of time: tf that was on its way comes after the buffer has been
  /// cleared, and makes it refuse all that follows as too old.
  void forget_the_future();
  const LaserPlace& mount_of(const std::string& frame);
  SlamScan placed(const sensor_msgs::LaserScan& message);

  ScanInputParams params_;
  Listener listener_;
  std::string last_frame_;  // of a laser
  std::map<std::string, LaserPlace> mounts_;
  ros::Time last_time_;
  double jumped_ = -1e9;  // when time did, steady clock [s]

  tf2_ros::Buffer buffer_{ros::Duration(120.0)};  // recordings are played fast
  std::unique_ptr<tf2_ros::TransformListener> tf_;
  LaserPoses poses_;
  message_filters::Subscriber<sensor_msgs::LaserScan> scans_;
  std::unique_ptr<tf2_ros::MessageFilter<sensor_msgs::LaserScan>> filter_;
};

}  // namespace falko_slam
