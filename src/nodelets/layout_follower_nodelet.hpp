// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <nav_msgs/Odometry.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>

#include <memory>
#include <string>

#include "encoder_input.hpp"
#include "falko_slam/ros_bridge/layout_follower_params.hpp"
#include "falko_slam/ros_bridge/topic_watch.hpp"

namespace falko_slam {

/// Leads a vehicle along a layout by the pose of the Localizer: `odometry` and encoders in,
/// `drive_command` and `operation_point` out. For simulations and trials: it sees no obstacles.
///
/// Commands come with every pose; without one for `pose_timeout`, and while it is paused, it
/// commands a halt. Parameters: config/layout_follower.yaml.
class LayoutFollowerNodelet : public nodelet::Nodelet {
 private:
  void onInit() override;
  void load_parameters();
  void on_pose(const nav_msgs::Odometry& message);
  void on_silence();
  bool on_pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void lead(const PosedMotion& motion);
  void publish(const WheelCommand& command);
  void publish_halts();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  LayoutFollowerNodeParams params_;
  std::unique_ptr<LayoutFollower> follower_;
  bool paused_ = false;
  std::optional<double> steering_;  // measured [rad]
  std::optional<ros::Time> last_pose_;
  std::string map_frame_;
  std::size_t published_halts_ = 0, halts_ = 0;
  double commanded_steering_ = 0.0;

  std::unique_ptr<TopicWatch> pose_watch_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::Publisher commands_, operation_points_;
  ros::ServiceServer pause_;
  ros::WallTimer diagnostics_timer_, silence_timer_;
  std::unique_ptr<EncoderInput> encoders_;
  ros::Subscriber poses_;  // goes first
};

}  // namespace falko_slam
