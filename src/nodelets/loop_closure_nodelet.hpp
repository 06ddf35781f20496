// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <falko_slam/GlobalLocalization.h>
#include <falko_slam/LoadKeyframes.h>
#include <falko_slam/SaveKeyframes.h>
#include <message_filters/subscriber.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <memory>
#include <mutex>
#include <string>

#include "falko_slam/place_recognition/keyframe_memory.hpp"
#include "falko_slam/ros_bridge/loop_diagnostics.hpp"
#include "falko_slam/ros_bridge/loop_markers.hpp"
#include "loop_closure_parameters.hpp"
#include "scan_filter.hpp"

namespace falko_slam {

/// LaserScan and tf in, keyframes and loop constraints out: a wrapper of KeyframeMemory.
///
/// Subscribes `scan`; publishes `keyframes`, `constraints`, and `loop_markers` to whom subscribes.
/// Services `~global_localization`, `~save_keyframes`, `~load_keyframes`. Parameters:
/// config/loop_closure.yaml.
///
/// Scans come one after the other from the nodelet's queue. Services come one after the other from
/// a queue and thread of our own, beside them; `mutex_` guards what both use, and files are read
/// and written without it. (The nodelet's multi-threaded queue would not do: on unloading it may be
/// gone before we are, and services need theirs to shut down.)
class LoopClosureNodelet : public nodelet::Nodelet {
 public:
  ~LoopClosureNodelet() override;

 private:
  void onInit() override;
  void load_parameters();
  void load_database();
  void start_publishing();
  void start_services();
  void start_listening();

  void on_received(const sensor_msgs::LaserScanConstPtr& message);
  void on_scan(const sensor_msgs::LaserScanConstPtr& message);
  void on_dropped(const std::string& missing);
  void on_timer();
  bool on_locate(GlobalLocalization::Request& request, GlobalLocalization::Response& response);
  bool on_save(SaveKeyframes::Request& request, SaveKeyframes::Response& response);
  bool on_load(LoadKeyframes::Request& request, LoadKeyframes::Response& response);

  /// Begins a drive if time has jumped back since the last call.
  void watch_time();
  void begin_drive(const std::string& reason);
  /// With the scan's parameters for a laser that hangs so.
  ScanReport normalized(const sensor_msgs::LaserScan& message, const LaserPlace& place,
                        LaserScan& scan) const;
  void add_keyframe(KeyframeRecord record);
  void locate(const sensor_msgs::LaserScan& message, std::size_t count,
              GlobalLocalization::Response& response);
  /// All keyframes are others now.
  void announce_reset();

  LoopClosureNodeParams params_;
  std::mutex mutex_;
  std::unique_ptr<KeyframeMemory> memory_;
  KeyframeSelector selector_;
  std::unique_ptr<LoopMarkers> loop_markers_;
  bool markers_changed_ = true;
  std::uint32_t marker_subscribers_ = 0;
  std::unique_ptr<LoopDiagnostics> diagnostics_;
  sensor_msgs::LaserScanConstPtr last_scan_;

  std::unique_ptr<ScanFilter> filter_;
  message_filters::Subscriber<sensor_msgs::LaserScan> scans_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::Publisher keyframes_, constraints_, markers_;
  ros::CallbackQueue service_queue_;
  ros::ServiceServer locate_, save_, load_;
  std::unique_ptr<ros::AsyncSpinner> service_thread_;
  ros::WallTimer timer_;
};

}  // namespace falko_slam
