// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void validate(const TricycleParams& params) {
  require_in_range("wheelbase", params.wheelbase, 0.05, 20.0);
  require_in_range("driving_scale", params.driving_scale, 1e-9, 1.0);
  require_in_range("steer_offset_forward", params.steer_offset_forward, -kPi, kPi);
  require_in_range("steer_offset_backward", params.steer_offset_backward, -kPi, kPi);
}

double true_steering(const TricycleParams& params, double steering, double ticks) {
  return steering + (ticks > 0.0 ? params.steer_offset_forward : params.steer_offset_backward);
}

// An arc is the exponential of a constant twist: (2.2), (2.3) times the time.
Pose2 drive_arc(const TricycleParams& params, double ticks, double steering) {
  const double way = params.driving_scale * ticks;
  const double direction = true_steering(params, steering, ticks);
  return Pose2::exp({way * std::cos(direction), 0.0, way * std::sin(direction) / params.wheelbase});
}

}  // namespace falko_slam
