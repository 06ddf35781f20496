// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>

#include "encoder_input.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/ros_bridge/odometry_node_params.hpp"

namespace falko_slam {

/// Encoders in, `odom` and tf out: a wrapper of TricycleOdometry that takes the file of a
/// calibration, and tells tf where the laser is by the same file.
///
/// The covariance of the pose grows with the way by OdometryNoise; that of the twist is the same
/// noise over the last step. Parameters: config/tricycle_odometry.yaml.
class TricycleOdometryNodelet : public nodelet::Nodelet {
 private:
  void onInit() override;
  void load_parameters();
  void start_publishing();
  void on_reading(const EncoderReading& reading);
  void on_late(const EncoderReading& reading);
  void publish(const OdometryStep& step, const EncoderReading& reading);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  OdometryNodeParams params_;
  std::unique_ptr<TricycleOdometry> odometry_;
  PoseEstimate odom_T_base_;
  std::size_t readings_ = 0, jumps_ = 0, late_ = 0;
  std::unique_ptr<TopicWatch> watch_;

  std::unique_ptr<tf2_ros::TransformBroadcaster> transforms_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> static_transforms_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::Publisher publisher_;
  ros::WallTimer diagnostics_timer_;
  std::unique_ptr<EncoderInput> encoders_;  // goes first
};

}  // namespace falko_slam
