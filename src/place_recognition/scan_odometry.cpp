// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_odometry.hpp"

#include <cmath>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

Pose2 mended_step(const ScanView& last, const ScanView& view, const Pose2& step,
                  const ScanOdometryParams& params) {
  const auto aligned = register_scans(last, view, step, params.registration);
  if (!aligned || aligned->constraint < params.min_constraint) return step;
  const Pose2& mended = aligned->target_T_source.pose;
  const Pose2 move = step.inverse() * mended;
  if (move.translation().norm() > params.max_move || std::abs(move.theta()) > params.max_turn) {
    return step;
  }
  if (agreement(last, view, mended, params.agreement).ratio() < params.min_agreement) return step;
  return mended;
}

}  // namespace

void validate(const ScanOdometryParams& params) {
  validate(params.view);
  validate(params.registration);
  validate(params.agreement);
  require_in_range("max_move", params.max_move, 0.0, 100.0);
  require_in_range("max_turn", params.max_turn, 0.0, kPi);
  require_in_range("min_agreement", params.min_agreement, 0.0, 1.0);
  require_in_range("min_constraint", params.min_constraint, 0.0, 1.0);
}

ScanOdometry::ScanOdometry(const ScanOdometryParams& params)
    : params_((validate(params), params)) {}

Pose2 ScanOdometry::add(const LaserScan& scan, const Pose2& odom_T_laser) {
  ScanView view(scan, params_.view);
  Pose2 mended = odom_T_laser;
  if (last_) {
    const Pose2 step = last_->odom_T_laser.inverse() * odom_T_laser;
    mended = last_->mended * mended_step(last_->view, view, step, params_);
  }
  last_ = Last{std::move(view), odom_T_laser, mended};
  return mended;
}

}  // namespace falko_slam
