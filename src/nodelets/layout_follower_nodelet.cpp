// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "layout_follower_nodelet.hpp"

#include <falko_slam/DriveCommand.h>
#include <falko_slam/OperationPoint.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"
#include "real_time.hpp"
#include "steady_now.hpp"

namespace falko_slam {
namespace {

constexpr double kSilencePeriod = 0.1;  // of looking for one [s]

geometry_msgs::Pose2D to_pose2d(const Pose2& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x();
  message.y = pose.y();
  message.theta = pose.theta();
  return message;
}

}  // namespace

void LayoutFollowerNodelet::onInit() {
  load_parameters();
  ros::NodeHandle& node = getNodeHandle();
  ros::NodeHandle& private_node = getPrivateNodeHandle();
  commands_ = node.advertise<DriveCommand>(topics::kDriveCommand, kQueue);
  operation_points_ = node.advertise<OperationPoint>(topics::kOperationPoint, kQueue);
  pause_ = private_node.advertiseService(topics::kPause, &LayoutFollowerNodelet::on_pause, this);
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, private_node, getName());
  updater_->setHardwareID("none");
  updater_->add("layout", [this](auto& status) { report(status); });
  diagnostics_timer_ = node.createWallTimer(ros::WallDuration(1.0),
                                            [this](const auto&) { updater_->force_update(); });
  silence_timer_ = node.createWallTimer(ros::WallDuration(kSilencePeriod),
                                        [this](const auto&) { on_silence(); });
  encoders_ =
      std::make_unique<EncoderInput>(node, params_.vehicle, [this](const EncoderReading& reading) {
        steering_ = steering_of(params_.encoders, reading.steer_ticks);
      });
  poses_ = node.subscribe<nav_msgs::Odometry>(
      topics::kLocalizedOdometry, kQueue,
      [this](const nav_msgs::OdometryConstPtr& message) { on_pose(*message); });
  pose_watch_ = std::make_unique<TopicWatch>(heard_topic<nav_msgs::Odometry>(poses_.getTopic()),
                                             steady_now());
}

void LayoutFollowerNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_layout_follower_params(parameter_tree(node), node.getNamespace(), unknown);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
  paused_ = params_.start_paused;
  follower_ = std::make_unique<LayoutFollower>(params_.follower, params_.layout);
}

void LayoutFollowerNodelet::on_pose(const nav_msgs::Odometry& message) {
  pose_watch_->heard(steady_now());
  last_pose_ = ros::Time::now();
  map_frame_ = message.header.frame_id;
  const Pose2 pose = in_plane(message.pose.pose);
  const double speed = message.twist.twist.linear.x;
  if (!std::isfinite(pose.x() + pose.y() + pose.theta() + speed)) {
    NODELET_WARN_STREAM_THROTTLE(5.0, poses_.getTopic()
                                          << ": a pose that is not finite is left out");
    return;
  }
  if (paused_) return publish({0.0, commanded_steering_});
  lead({from_ros(message.header.stamp), pose, speed, steering_});
}

void LayoutFollowerNodelet::lead(const PosedMotion& motion) {
  publish(follower_->next(motion));
  publish_halts();
  if (!follower_->done() || !params_.repeat) return;
  follower_->begin_again();
  published_halts_ = 0;
}

// Of a stopped clock, too: the pose's age is that of ROS's time.
void LayoutFollowerNodelet::on_silence() {
  if (!last_pose_) return;
  const double age = std::abs((ros::Time::now() - *last_pose_).toSec());
  if (age > params_.pose_timeout) publish({0.0, commanded_steering_});
}

bool LayoutFollowerNodelet::on_pause(std_srvs::SetBool::Request& request,
                                     std_srvs::SetBool::Response& response) {
  paused_ = request.data;
  response.success = 1;
  response.message = paused_ ? "halts" : "drives on";
  return true;
}

void LayoutFollowerNodelet::publish(const WheelCommand& command) {
  DriveCommand message;
  message.header.stamp = ros::Time::now();
  message.wheel_speed = command.wheel_speed;
  message.steering = commanded_steering_ = command.steering;
  commands_.publish(message);
}

void LayoutFollowerNodelet::publish_halts() {
  for (; published_halts_ < follower_->halts().size(); ++published_halts_) {
    const Halt& halt = follower_->halts()[published_halts_];
    if (halt.name.empty()) continue;
    OperationPoint message;
    message.header.stamp = to_ros(halt.stamp);
    message.header.frame_id = map_frame_;
    message.name = halt.name;
    message.planned = to_pose2d(halt.map_T_planned);
    message.pose = to_pose2d(halt.map_T_base);
    message.after_curve = static_cast<std::uint8_t>(halt.after_curve);
    operation_points_.publish(message);
    ++halts_;
  }
}

void LayoutFollowerNodelet::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const std::string trouble = pose_watch_->trouble(steady_now());
  if (!trouble.empty()) {
    status.summary(DiagnosticStatus::WARN, "halts: " + trouble);
  } else {
    const bool done = follower_->done();
    status.summary(DiagnosticStatus::OK, paused_ ? "paused" : done ? "done" : "drives");
  }
  status.add("layout", params_.layout_file);
  status.add("operation points reached", halts_);
  status.add("left of the path [mm]", 1e3 * follower_->cross_track());
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::LayoutFollowerNodelet, nodelet::Nodelet)
