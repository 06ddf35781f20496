// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/transform_slew.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

// The share of `way` that `speed` allows in that time.
double share_of(double way, double speed, double seconds) {
  if (speed <= 0.0 || way <= 0.0) return 1.0;
  return std::min(1.0, speed * std::max(0.0, seconds) / way);
}

}  // namespace

void validate(const TransformSlewParams& params) {
  require_in_range("max_speed", params.max_speed, 0.0, 1e6);
  require_in_range("max_turn_speed", params.max_turn_speed, 0.0, 1e6);
}

TransformSlew::TransformSlew(const TransformSlewParams& params)
    : params_((validate(params), params)) {}

void TransformSlew::aim(const Pose2& map_T_odom, const Pose2& odom_T_base) {
  if (!target_) now_ = map_T_odom;
  target_ = map_T_odom;
  odom_T_base_ = odom_T_base;
}

std::optional<Pose2> TransformSlew::advance(double seconds) {
  if (!target_) return std::nullopt;
  const Pose2 here = now_ * odom_T_base_;
  const Pose2 there = *target_ * odom_T_base_;
  const Pose2 rest = here.inverse() * there;
  const double move = share_of(rest.translation().norm(), params_.max_speed, seconds);
  const double turn = share_of(std::abs(rest.theta()), params_.max_turn_speed, seconds);
  if (move >= 1.0 && turn >= 1.0) {
    now_ = *target_;
  } else {
    const Pose2 part(move * rest.translation(), turn * rest.theta());
    now_ = here * part * odom_T_base_.inverse();
  }
  return now_;
}

}  // namespace falko_slam
