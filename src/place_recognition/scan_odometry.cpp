// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_odometry.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
void validate(const ScanOdometryParams& params) {
  require_in_range("max_move", params.max_move, 0.0, 100.0);
  require_in_range("max_turn", params.max_turn, 0.0, kPi);
  require_in_range("min_agreement", params.min_agreement, 0.0, 1.0);
  require_in_range("min_constraint", params.min_constraint, 0.0, 1.0);
}

ScanOdometry::ScanOdometry(const ScanOdometryParams& params, const RegistrationParams& registration,
                           const AgreementParams& agreement)
    : params_((validate(params), params)),
      registration_((validate(registration), registration)),
      agreement_((validate(agreement), agreement)) {}

Pose2 ScanOdometry::mended_step(const ScanView& view, const Pose2& step) const {
  if (params_.max_move == 0.0) return step;
  const auto aligned = register_scans(last_->view, view, step, registration_);
  if (!aligned || aligned->constraint < params_.min_constraint) return step;
  const Pose2& mended = aligned->target_T_source.pose;
  const Pose2 move = step.inverse() * mended;
  if (move.translation().norm() > params_.max_move || std::abs(move.theta()) > params_.max_turn) {
    return step;
  }
  const Agreement found = agreement(last_->view, view, mended, agreement_);
  return found.ratio() < params_.min_agreement ? step : mended;
}

Pose2 ScanOdometry::add(const ScanView& view, const Pose2& odom_T_laser) {
  Pose2 mended = odom_T_laser;
  if (last_) {
    const Pose2 step = last_->odom_T_laser.inverse() * odom_T_laser;
    mended = last_->mended * mended_step(view, step);
  }
  last_ = Last{view, odom_T_laser, mended};
  return mended;
}

}  // namespace falko_slam
