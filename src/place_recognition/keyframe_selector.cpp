// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_selector.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void validate(const KeyframeSelectorParams& params) {
  require_in_range("min_step", params.min_step, 0.0, 100.0);
  require_in_range("min_turn", params.min_turn, 0.0, kPi);
  require_in_range("max_jump", params.max_jump, 0.1, 1e6);
}

KeyframeSelector::KeyframeSelector(const KeyframeSelectorParams& params)
    : params_((validate(params), params)) {}

KeyframeSelector::Choice KeyframeSelector::choose(const Pose2& odom_T_laser) {
  if (!odom_T_laser.translation().allFinite() || !std::isfinite(odom_T_laser.theta())) {
    return Choice::kPassOver;
  }
  const bool jumped =
      last_ && (odom_T_laser.translation() - last_->translation()).norm() > params_.max_jump;
  last_ = odom_T_laser;
  if (keyframe_ && !jumped) {
    const Pose2 step = keyframe_->inverse() * odom_T_laser;
    if (step.translation().norm() < params_.min_step && std::abs(step.theta()) < params_.min_turn) {
      return Choice::kPassOver;
    }
  }
  keyframe_ = odom_T_laser;
  return jumped ? Choice::kFirstOfNew : Choice::kKeyframe;
}

void KeyframeSelector::reset() {
  keyframe_.reset();
  last_.reset();
}

}  // namespace falko_slam
