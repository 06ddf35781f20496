// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle_odometry.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

void validate(const TricycleOdometryParams& params) {
  require_in_range("max_wheel_speed", params.max_wheel_speed, 0.0, 100.0);
}

TricycleOdometry::TricycleOdometry(const TricycleParams& tricycle, const EncoderParams& encoders,
                                   const Pose2& odom_T_base, const TricycleOdometryParams& params)
    : tricycle_(tricycle), encoders_(encoders), params_(params), odom_T_base_(odom_T_base) {
  validate(tricycle_);
  validate(encoders_);
  validate(params_);
}

OdometryStep TricycleOdometry::add(const EncoderReading& reading) {
  OdometryStep step;
  if (last_) {
    step.ticks = ticks_between(last_->drive_ticks, reading.drive_ticks);
    step.time = reading.stamp - last_->stamp;
    step.verdict = judge(step);
    if (step.verdict == OdometryVerdict::kNotLater) return step;
    if (step.verdict == OdometryVerdict::kIntegrated) {
      integrate(reading, step);
    } else {
      velocity_ = {};
    }
  }
  last_ = reading;
  return step;
}

void TricycleOdometry::restart() {
  last_.reset();
  velocity_ = {};
}

OdometryVerdict TricycleOdometry::judge(const OdometryStep& step) const {
  if (step.time <= Duration::zero()) return OdometryVerdict::kNotLater;
  const double way = std::abs(tricycle_.driving_scale * step.ticks);
  const bool judged = params_.max_wheel_speed > 0.0;
  const bool jump = judged && way > params_.max_wheel_speed * to_seconds(step.time);
  return jump ? OdometryVerdict::kJump : OdometryVerdict::kIntegrated;
}

void TricycleOdometry::integrate(const EncoderReading& reading, OdometryStep& step) {
  const double turned = steering_between(encoders_, last_->steer_ticks, reading.steer_ticks);
  step.steering = steering_of(encoders_, last_->steer_ticks) + 0.5 * turned;
  odom_T_base_ = odom_T_base_ * drive_arc(tricycle_, step.ticks, step.steering);

  const double wheel_speed = tricycle_.driving_scale * step.ticks / to_seconds(step.time);
  const double direction = true_steering(tricycle_, step.steering, step.ticks);
  velocity_.forward = wheel_speed * std::cos(direction);
  velocity_.turn_rate = wheel_speed * std::sin(direction) / tricycle_.wheelbase;
}

}  // namespace falko_slam
