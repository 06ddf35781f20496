// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/map_transform.hpp"

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {

MapTransform::MapTransform(const MapTransformParams& params)
    : params_(params), slew_(params.slew) {}

void MapTransform::set(const Pose2& map_T_child, const Pose2& child_T_base, const ros::Time& now) {
  slew_.aim(map_T_child, child_T_base);
  known_ = true;
  news_ = now;
}

void MapTransform::reset() {
  known_ = false;
  slew_.reset();
}

void MapTransform::rewind() {
  reset();
  last_stamp_ = last_now_ = ros::Time();
}

bool MapTransform::is_stale(const ros::Time& now) const {
  return !held_ && (now - news_).toSec() > params_.timeout;
}

std::optional<geometry_msgs::TransformStamped> MapTransform::at(const ros::Time& now) {
  // Time 0: that of a simulation has not begun.
  if (!known_ || now.isZero() || is_stale(now)) return std::nullopt;
  const ros::Time stamp = now + ros::Duration(params_.tolerance);
  if (stamp <= last_stamp_) return std::nullopt;
  const double seconds = last_now_.isZero() ? 0.0 : (now - last_now_).toSec();
  const std::optional<Pose2> map_T_child = slew_.advance(seconds);
  last_stamp_ = stamp;
  last_now_ = now;
  return to_transform(*map_T_child, from_ros(stamp), params_.map_frame, params_.child_frame)
      .transforms.front();
}

}  // namespace falko_slam
