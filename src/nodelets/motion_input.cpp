// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion_input.hpp"

#include <cmath>
#include <utility>

#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"

namespace falko_slam {
MotionInput::MotionInput(const ros::NodeHandle& node, const LocalizerNodeParams& params,
                         Listener listener)
    : params_(params),
      listener_(std::move(listener)),
      odometry_(params.calibration.tricycle, params.encoders) {
  ros::NodeHandle own(node);
  if (params_.motion_source == MotionSource::kEncoders) {
    encoders_ = std::make_unique<EncoderInput>(
        own, params_.vehicle, [this](const EncoderReading& reading) { on_reading(reading); });
  } else {
    odometry_messages_ =
        own.subscribe(topics::kOdometry, kMotionQueue, &MotionInput::on_odometry, this);
  }
}

HeardTopic MotionInput::topic() const {
  return encoders_ ? encoders_->topic()
                   : heard_topic<nav_msgs::Odometry>(odometry_messages_.getTopic());
}

// A stamp that is a little early is a slip, and left out; after one that is long ago a clock has
// been set back.
bool MotionInput::is_late(Time stamp, Time last) {
  const Duration back = last - stamp;
  if (back <= kClockTolerance) return true;
  listener_.time_has_jumped(to_seconds(back));
  return false;
}

void MotionInput::on_reading(const EncoderReading& reading) {
  const Pose2 before = odometry_.odom_T_base();
  OdometryStep step = odometry_.add(reading);
  if (step.verdict == OdometryVerdict::kNotLater) {
    if (is_late(reading.stamp, odometry_.reading()->stamp)) return;
    odometry_.restart();
    step = odometry_.add(reading);
  }
  VehicleMotion moved;
  moved.stamp = reading.stamp;
  moved.velocity = odometry_.velocity();
  if (step.verdict == OdometryVerdict::kIntegrated) {
    moved.motion = {
        before.inverse() * odometry_.odom_T_base(),
        arc_covariance(params_.calibration.tricycle, step.ticks, step.steering, params_.noise)};
  }
  listener_.moved(moved);
}

// Its own covariance is that of the pose since its start: what a step adds is not in it.
PoseEstimate MotionInput::motion_of(const Pose2& motion) const {
  const MotionNoise& noise = params_.odometry_noise;
  const double way = motion.translation().norm();
  const double turn = std::abs(motion.theta());
  PoseEstimate estimate{motion, Eigen::Matrix3d::Zero()};
  const double along = noise.distance * noise.distance * way;
  const double about =
      noise.turn * noise.turn * way + noise.turn_by_turn * noise.turn_by_turn * turn;
  estimate.covariance.diagonal() << along, along, about;
  return estimate;
}

void MotionInput::on_odometry(const nav_msgs::OdometryConstPtr& message) {
  const std::string base = tf_frame(message->child_frame_id);
  if (!base.empty() && base != params_.base_frame) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "odometry of " << base << " on " << topic().name
                                                            << ", not of " << params_.base_frame
                                                            << ": it is not used");
    return;
  }
  VehicleMotion moved;
  moved.stamp = from_ros(message->header.stamp);
  moved.odom_T_base = in_plane(message->pose.pose);
  moved.velocity = {message->twist.twist.linear.x, message->twist.twist.angular.z};
  if (!moved.odom_T_base->translation().allFinite() || !std::isfinite(moved.odom_T_base->theta())) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod,
                             "odometry on " << topic().name << " that is not finite");
    return;
  }
  if (last_stamp_ && moved.stamp <= *last_stamp_) {
    if (is_late(moved.stamp, *last_stamp_)) return;
    last_stamp_.reset();
  }
  if (last_stamp_) moved.motion = motion_of(last_odom_T_base_.inverse() * *moved.odom_T_base);
  last_stamp_ = moved.stamp;
  last_odom_T_base_ = *moved.odom_T_base;
  listener_.moved(moved);
}

}  // namespace falko_slam
