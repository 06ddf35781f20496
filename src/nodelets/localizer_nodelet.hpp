// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <falko_slam/ReflectorArray.h>
#include <falko_slam/SetPose.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "falko_slam/localization/localizer.hpp"
#include "falko_slam/ros_bridge/localizer_diagnostics.hpp"
#include "falko_slam/ros_bridge/localizer_node_params.hpp"
#include "falko_slam/ros_bridge/map_transform.hpp"
#include "motion_input.hpp"

namespace falko_slam {

/// Motions, scans or reflectors in, the pose on a map of landmarks and its status out: a wrapper of
/// Localizer.
///
/// Topics and services: README.md. Parameters: config/localizer.yaml.
///
/// All callbacks come one after the other from a queue and thread of our own: the vehicle must not
/// wait for the other nodelets of a manager.
class LocalizerNodelet : public nodelet::Nodelet {
 public:
  ~LocalizerNodelet() override;

 private:
  struct PlacedBase {
    Time stamp{};
    Pose2 map_T_base;
    std::optional<Pose2> odom_T_base;  ///< empty: tf knows
  };

  static constexpr std::size_t kMotionsKept = 100;

  void onInit() override;
  void load_parameters();
  void load_map();
  void start_publishing();
  void start_listening();
  void start_watching();
  void start_serving();

  void on_motion(const VehicleMotion& motion);
  void on_time_jump(double seconds);
  void on_scan(const sensor_msgs::LaserScan& message);
  void on_reflectors(const ReflectorArray& message);
  void seen(double began);
  void on_timer();

  // localizer_outputs.cpp
  void publish_motion();
  void publish_sight();
  void publish_status();
  void place_map();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  void check_mount(const std::string& laser_frame);

  // localizer_services.cpp
  void begin(Time stamp);
  std::string take(const geometry_msgs::PoseWithCovarianceStamped& message);
  void forget_way();
  void on_initial_pose(const geometry_msgs::PoseWithCovarianceStamped& message);
  bool on_set_pose(SetPose::Request& request, SetPose::Response& response);
  bool on_global_localization(std_srvs::Trigger::Request& request,
                              std_srvs::Trigger::Response& response);
  void save_pose();

  /// Now in the time of the inputs' stamps, which need not be that of this machine.
  Time now() const;
  void note_stamp(Time stamp);

  LocalizerNodeParams params_;
  LandmarkMap map_;
  std::string map_identity_;
  std::unique_ptr<Localizer> localizer_;
  std::unique_ptr<MapTransform> transform_;
  std::unique_ptr<LocalizerDiagnostics> diagnostics_;
  std::deque<PlacedBase> placed_;  // the last motions
  BaseVelocity velocity_;
  std::optional<Time> newest_;  // stamp of an input
  ros::Time newest_received_;
  bool begun_ = false;
  std::string mount_checked_;  // frame of the laser
  std::optional<std::pair<LocalizationStatus, LocalizationReason>> told_;
  LaserScan scan_;  // its memory is used again

  ros::CallbackQueue queue_;
  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> transforms_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  std::unique_ptr<MotionInput> motions_;
  ros::Subscriber sights_, initial_poses_;
  ros::Publisher pose_, odometry_, landmarks_, markers_, status_;
  ros::ServiceServer set_pose_, global_localization_;
  ros::Timer timer_;
  ros::WallTimer diagnostics_timer_, save_timer_;
  std::unique_ptr<ros::AsyncSpinner> thread_;
};

}  // namespace falko_slam
