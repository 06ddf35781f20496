// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/pose_handover.hpp"

#include <tf2/exceptions.h>

#include <stdexcept>
#include <utility>

#include "falko_slam/ros_bridge/localizer_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

constexpr double kOldest = 2.0;        // of a pose that is kept [s]
constexpr double kFarthestStep = 5.0;  // from one look to the next; more is another odometry [m]
constexpr double kFarthestWay = 30.0;  // then one may as well search [m]
// Deviations when it stands, and what a metre adds; the odometry of a vehicle that is not
// calibrated does not do worse (doc/results.md, calibration).
constexpr double kPositionDeviation = 0.02, kPositionDrift = 0.03;  // [m], [m/m]
constexpr double kHeadingDeviation = 0.005, kHeadingDrift = 0.005;  // [rad], [rad/m]

}  // namespace

PoseHandover::PoseHandover(const tf2::BufferCore& transforms, std::string odom_frame,
                           std::string base_frame)
    : transforms_(transforms),
      odom_frame_(std::move(odom_frame)),
      base_frame_(std::move(base_frame)) {}

geometry_msgs::TransformStamped PoseHandover::odom_T_base(ros::Time stamp) const {
  return transforms_.lookupTransform(odom_frame_, base_frame_, stamp);
}

void PoseHandover::keep(const std::string& map,
                        const geometry_msgs::PoseWithCovarianceStamped& map_T_base, ros::Time now) {
  kept_.reset();
  if ((now - map_T_base.header.stamp).toSec() > kOldest) return;
  try {
    Kept kept;
    kept.map = map;
    kept.map_frame = map_T_base.header.frame_id;
    kept.map_T_base = from_message(map_T_base, kept.map_frame, InitialPose());
    kept.odom_T_base = in_plane(odom_T_base(map_T_base.header.stamp).transform);
    kept.odom_T_latest = kept.odom_T_base;
    kept.latest = map_T_base.header.stamp;
    kept_ = kept;
  } catch (const tf2::TransformException&) {
  } catch (const std::invalid_argument&) {
  }
}

void PoseHandover::follow() {
  if (!kept_) return;
  try {
    const geometry_msgs::TransformStamped latest = odom_T_base(ros::Time(0));
    const Pose2 odom_T_latest = in_plane(latest.transform);
    const double step = (kept_->odom_T_latest.inverse() * odom_T_latest).translation().norm();
    kept_->way += step;
    kept_->odom_T_latest = odom_T_latest;
    const bool goes_on = latest.header.stamp >= kept_->latest && step < kFarthestStep;
    kept_->latest = latest.header.stamp;
    if (!goes_on || kept_->way > kFarthestWay) kept_.reset();
  } catch (const tf2::TransformException&) {
    kept_.reset();
  }
}

std::optional<geometry_msgs::PoseWithCovarianceStamped> PoseHandover::pose_on(
    const std::string& map) const {
  if (!kept_ || kept_->map != map) return std::nullopt;
  const PoseEstimate motion{kept_->odom_T_base.inverse() * kept_->odom_T_latest,
                            pose_covariance(kPositionDeviation + kPositionDrift * kept_->way,
                                            kHeadingDeviation + kHeadingDrift * kept_->way)};
  return pose_message(compose(kept_->map_T_base, motion), from_ros(kept_->latest),
                      kept_->map_frame);
}

}  // namespace falko_slam
