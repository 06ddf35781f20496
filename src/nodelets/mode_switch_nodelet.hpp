// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <falko_slam/SaveState.h>
#include <falko_slam/SetMode.h>
#include <nav_msgs/Odometry.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>

#include "falko_slam/ros_bridge/mode_switch_params.hpp"
#include "falko_slam/ros_bridge/pose_handover.hpp"
#include "manager_client.hpp"

namespace falko_slam {

/// Lets a vehicle either make a map or find itself on one: holds PoseGraph or Localizer in a
/// nodelet manager, never both, for both send tf map -> odom.
///
/// Service `~set_mode`; publishes `~mode`, latched: mapping, localization, or none. Looks after the
/// nodelet of the mode: one that is gone, with its manager or without, is loaded again. Back from
/// mapping the Localizer is told where the vehicle is now. Parameters: config/mode_switch.yaml.
///
/// Best a node of its own (bin mode_switch): it outlives the manager. Started again it takes over
/// what runs. All callbacks come one after the other from a queue and thread of our own, which may
/// wait for the manager.
class ModeSwitchNodelet : public nodelet::Nodelet {
 public:
  ~ModeSwitchNodelet() override;

 private:
  void onInit() override;
  void load_parameters();
  void start();

  void on_pose(const nav_msgs::Odometry& message);
  void on_timer();
  void supervise();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  void publish_mode(const std::string& mode);

  // mode_switch_changes.cpp
  bool on_set_mode(SetMode::Request& request, SetMode::Response& response);
  /// Returns what was done. Throws std::runtime_error with what was not.
  std::string change(VehicleMode mode, const SetMode::Request& request);
  void require_readable(VehicleMode mode, const std::string& file) const;
  std::string file_of(VehicleMode mode, const std::string& wished) const;
  void autosave();
  /// State and occupancy grid; returns what the state's service was asked and said.
  SaveState save_map() const;
  /// With the file as its parameter.
  void load(VehicleMode mode, const std::string& file);
  /// Tells the Localizer, which was just loaded, where the vehicle is on this map if that is known.
  /// Returns what came of it, empty if it is not.
  std::string hand_over(const std::string& map);

  ManagedNodelet nodelet_of(VehicleMode mode) const;
  std::string file_parameter(VehicleMode mode) const;

  ModeSwitchParams params_;
  VehicleMode mode_ = VehicleMode::kLocalization;
  bool manager_answers_ = false, runs_ = false;
  std::size_t loads_ = 0;  // without being asked
  std::string trouble_;    // of loading
  std::string unsaved_;    // why there is no newer state of mapping
  ros::SteadyTime autosaved_;
  std::string published_;
  std::string refusal_;
  ros::SteadyTime refused_;

  ros::CallbackQueue queue_;
  std::unique_ptr<ManagerClient> manager_;
  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> transforms_;  // with a thread of its own
  std::unique_ptr<PoseHandover> handover_;
  geometry_msgs::PoseWithCovarianceStamped pose_;  // of the Localizer, the last
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::Publisher mode_publisher_;
  ros::Subscriber poses_;
  ros::ServiceServer set_mode_;
  ros::WallTimer timer_;
  std::unique_ptr<ros::AsyncSpinner> thread_;
};

}  // namespace falko_slam
