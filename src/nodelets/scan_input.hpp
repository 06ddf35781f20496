// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "falko_slam/slam/feature_slam.hpp"
#include "scan_filter.hpp"

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

  /// To be called now and then, for times without scans.
  void watch_time();

 private:
  using Message = sensor_msgs::LaserScanConstPtr;
  void on_received(const Message& message);
  void on_placed(const Message& message);
  const LaserPlace& mount_of(const std::string& frame);
  SlamScan placed(const sensor_msgs::LaserScan& message);

  ScanInputParams params_;
  Listener listener_;
  std::map<std::string, LaserPlace> mounts_;
  ScanFilter filter_;
  message_filters::Subscriber<sensor_msgs::LaserScan> scans_;  // goes first
};

}  // namespace falko_slam
