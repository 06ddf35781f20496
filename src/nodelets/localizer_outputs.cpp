// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the Localizer nodelet says.
#include <cmath>

#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/localizer_conversion.hpp"
#include "falko_slam/ros_bridge/localizer_markers.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "localizer_nodelet.hpp"

namespace falko_slam {
namespace {

// By more than this tf and the calibration do not mean the same mount [m], [rad].
constexpr double kMountDistance = 0.02;
constexpr double kMountTurn = 0.02;

}  // namespace

void LocalizerNodelet::publish_motion() {
  const LocalizerReport& state = localizer_->state();
  nav_msgs::Odometry message =
      odometry_message(state.map_T_base->pose, state.stamp, params_.map_frame, params_.base_frame);
  message.pose = to_message(*state.map_T_base);
  message.twist.twist.linear.x = velocity_.forward;
  message.twist.twist.angular.z = velocity_.turn_rate;
  odometry_.publish(message);
}

void LocalizerNodelet::publish_sight() {
  const LocalizerReport& state = localizer_->state();
  if (state.map_T_base) {
    pose_.publish(pose_message(*state.map_T_base, state.stamp, params_.map_frame));
    landmarks_.publish(landmarks_in_use(state, map_, localizer_->landmarks(), params_.map_frame));
  }
  publish_status();
  if (markers_.getNumSubscribers() == 0) return;
  markers_.publish(localizer_markers(state, map_, localizer_->landmarks(),
                                     params_.localizer.base_T_laser, params_.map_frame));
}

void LocalizerNodelet::publish_status() {
  const LocalizerReport& state = localizer_->state();
  const auto telling = std::make_pair(state.status, state.reason);
  if (told_ && told_ != telling) {
    const std::string words = std::string(name_of(state.status)) + ": " + describe(state.reason);
    if (state.status == LocalizationStatus::kOk) {
      NODELET_INFO_STREAM(name_of(state.status));
    } else {
      NODELET_WARN_STREAM(words);
    }
  }
  told_ = telling;
  status_.publish(to_message(state, params_.map_frame));
}

// From the newest motion that tf knows the odometry of; that may lag behind.
void LocalizerNodelet::place_map() {
  for (auto placed = placed_.rbegin(); placed != placed_.rend(); ++placed) {
    std::optional<Pose2> odom_T_base = placed->odom_T_base;
    const ros::Time stamp = to_ros(placed->stamp);
    if (!odom_T_base && buffer_.canTransform(params_.odom_frame, params_.base_frame, stamp)) {
      odom_T_base = in_plane(
          buffer_.lookupTransform(params_.odom_frame, params_.base_frame, stamp).transform);
    }
    if (!odom_T_base) continue;
    transform_->set(placed->map_T_base * odom_T_base->inverse(), *odom_T_base, ros::Time::now());
    return diagnostics_->warn_of_odometry("");
  }
  // Of all the motions that are kept none is known: tf does not merely lag behind.
  if (placed_.size() < kMotionsKept) return;
  diagnostics_->warn_of_odometry("no transform from " + params_.base_frame + " to " +
                                 params_.odom_frame + " at the stamps of the motions: tf " +
                                 params_.map_frame + " -> " + params_.odom_frame + " is not sent");
}

// The calibration counts, but somebody may have forgotten to give it.
void LocalizerNodelet::check_mount(const std::string& laser_frame) {
  if (mount_checked_ == laser_frame) return;
  LaserPlace place;
  try {
    place = LaserPoses(buffer_, params_.odom_frame, params_.base_frame).mount(laser_frame);
  } catch (const tf2::TransformException&) {
    return;  // once more with the next scan
  }
  mount_checked_ = laser_frame;
  const Pose2 off = params_.localizer.base_T_laser.inverse() * place.base_T_laser;
  const bool turned = place.upside_down.value_or(false) != params_.scan.upside_down;
  const bool moved =
      off.translation().norm() > kMountDistance || std::abs(off.theta()) > kMountTurn;
  std::string warning;
  if (turned) warning = "tf and parameter scan/upside_down do not agree on how the laser hangs";
  if (moved) warning = "tf and the parameters of the vehicle do not agree on where the laser is";
  diagnostics_->warn_of_mount(warning);
  if (!warning.empty()) NODELET_WARN_STREAM(warning << " (" << laser_frame << ")");
}

void LocalizerNodelet::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  diagnostics_->report(status, ros::SteadyTime::now().toSec(), localizer_->state());
}

}  // namespace falko_slam
