// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// The asymmetric tricycle of \cite kallasi2017, 2.1.2: one driven and steered wheel in front of a
/// rear axle whose middle is base_link. With equal offsets it is the standard one (2.1.1).
struct TricycleParams {
  double wheelbase = 1.358;            ///< L, rear axle to driven wheel [m]
  double driving_scale = 2.5e-4;       ///< s_w, way of the driven wheel per tick [m]
  double steer_offset_forward = 0.0;   ///< alpha_F, added to the measured steering [rad]
  double steer_offset_backward = 0.0;  ///< alpha_B [rad]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const TricycleParams& params);

/// The wheel's true direction (2.6): what the encoder says and the offset of the driving direction
/// [rad].
double true_steering(const TricycleParams& params, double steering, double ticks);

/// Where the vehicle comes to, seen from where it was, if the driven wheel turns this many ticks at
/// a measured steering that stays [rad]: (2.8), (2.9), also of a straight line.
Pose2 drive_arc(const TricycleParams& params, double ticks, double steering);

}  // namespace falko_slam
