// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <falko_slam/KeypointDetectorConfig.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <memory>
#include <string>

#include "falko_slam/features/feature_extractor.hpp"
#include "falko_slam/ros_bridge/laser_mount.hpp"
#include "falko_slam/ros_bridge/scan_diagnostics.hpp"

namespace falko_slam {

/// LaserScan in, FALKO features out: a wrapper of FeatureExtractor.
///
/// Subscribes `scan`; publishes `features`, and `feature_markers` and `keypoint_cloud` to whom
/// subscribes. Parameters: config/keypoint_detector.yaml; those of FALKO can be changed while it
/// runs. All callbacks come one after the other from the nodelet's single-threaded queue: no mutex.
class KeypointDetectorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override;

  void load_parameters();
  void on_scan(const sensor_msgs::LaserScanConstPtr& message);
  /// What is refused is set back in `config`.
  void on_reconfigure(KeypointDetectorConfig& config);
  void look_up_mount(const std::string& laser_frame);
  void warn_about(const ScanReport& report);
  void publish(const std_msgs::Header& header);

  std::unique_ptr<FeatureExtractor> extractor_;
  std::unique_ptr<LaserMount> mount_;
  std::string base_frame_;
  std::unique_ptr<ScanDiagnostics> diagnostics_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  std::unique_ptr<dynamic_reconfigure::Server<KeypointDetectorConfig>> reconfigure_;
  ros::Subscriber scans_;
  ros::Publisher features_, markers_, cloud_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace falko_slam
