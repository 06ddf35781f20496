// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tricycle_odometry_nodelet.hpp"

#include <nav_msgs/Odometry.h>

#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"
#include "steady_now.hpp"

namespace falko_slam {
void TricycleOdometryNodelet::onInit() {
  // All that may throw comes first.
  load_parameters();
  start_publishing();
  encoders_ = std::make_unique<EncoderInput>(
      getNodeHandle(), params_.vehicle,
      [this](const EncoderReading& reading) { on_reading(reading); });
  watch_ = std::make_unique<TopicWatch>(encoders_->topic(), steady_now(), params_.encoder_timeout);
  updater_->add("odometry",
                [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
}

void TricycleOdometryNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_odometry_node_params(parameter_tree(node), node.getNamespace(), unknown);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
  odometry_ = std::make_unique<TricycleOdometry>(params_.calibration.tricycle, params_.encoders,
                                                 Pose2(), params_.odometry);
}

void TricycleOdometryNodelet::start_publishing() {
  ros::NodeHandle& node = getNodeHandle();
  publisher_ = node.advertise<nav_msgs::Odometry>(topics::kOdometry, kQueue);
  if (params_.publish_tf) transforms_ = std::make_unique<tf2_ros::TransformBroadcaster>();
  if (params_.publish_laser_tf) {
    static_transforms_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
    static_transforms_->sendTransform(to_transform(params_.calibration.base_T_laser,
                                                   from_ros(ros::Time::now()), params_.base_frame,
                                                   params_.laser_frame)
                                          .transforms);
  }
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
  updater_->setHardwareID("none");
  diagnostics_timer_ = node.createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_->force_update(); });
}

void TricycleOdometryNodelet::on_reading(const EncoderReading& reading) {
  ++readings_;
  watch_->heard(steady_now());
  const Pose2 before = odometry_->odom_T_base();
  const OdometryStep step = odometry_->add(reading);
  switch (step.verdict) {
    case OdometryVerdict::kNotLater:
      return on_late(reading);
    case OdometryVerdict::kJump:
      ++jumps_;
      NODELET_WARN_STREAM("the drive counter has jumped by " << step.ticks
                                                             << " ticks: the pose stays");
      break;
    case OdometryVerdict::kIntegrated:
      odom_T_base_ = compose(odom_T_base_, {before.inverse() * odometry_->odom_T_base(),
                                            arc_covariance(params_.calibration.tricycle, step.ticks,
                                                           step.steering, params_.noise)});
      odom_T_base_.pose = odometry_->odom_T_base();  // not once more rounded
      break;
    case OdometryVerdict::kFirst:
      break;
  }
  publish(step, reading);
}

// A stamp that is a little early is a slip; after one that is long ago a clock has been set back.
void TricycleOdometryNodelet::on_late(const EncoderReading& reading) {
  ++late_;
  const Duration back = odometry_->reading()->stamp - reading.stamp;
  if (back <= kClockTolerance) return;
  NODELET_WARN_STREAM("time has jumped back by " << to_seconds(back)
                                                 << " s: odometry goes on where it was");
  odometry_->restart();
  odometry_->add(reading);
}

void TricycleOdometryNodelet::publish(const OdometryStep& step, const EncoderReading& reading) {
  nav_msgs::Odometry message = odometry_message(odometry_->odom_T_base(), reading.stamp,
                                                params_.odom_frame, params_.base_frame);
  message.pose = to_message(odom_T_base_);
  message.twist.twist.linear.x = odometry_->velocity().forward;
  message.twist.twist.angular.z = odometry_->velocity().turn_rate;
  if (step.verdict == OdometryVerdict::kIntegrated) {
    const Eigen::Matrix3d noise =
        arc_covariance(params_.calibration.tricycle, step.ticks, step.steering, params_.noise) /
        (to_seconds(step.time) * to_seconds(step.time));
    message.twist.covariance[0] = noise(0, 0);
    message.twist.covariance[5] = message.twist.covariance[30] = noise(0, 2);
    message.twist.covariance[35] = noise(2, 2);
  }
  publisher_.publish(message);
  if (!transforms_) return;
  transforms_->sendTransform(
      to_transform(odometry_->odom_T_base(), reading.stamp, params_.odom_frame, params_.base_frame)
          .transforms);
}

void TricycleOdometryNodelet::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  status.summary(DiagnosticStatus::OK, "running");
  const std::string trouble = watch_->trouble(steady_now());
  if (!trouble.empty()) status.summary(DiagnosticStatus::WARN, trouble);
  status.add("readings", readings_);
  status.add("readings left out, not later than the one before", late_);
  status.add("jumps of the counter", jumps_);
  status.add("calibration", params_.vehicle.calibration_file.empty()
                                ? "by parameters"
                                : params_.vehicle.calibration_file);
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::TricycleOdometryNodelet, nodelet::Nodelet)
