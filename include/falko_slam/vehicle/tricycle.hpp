// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

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

/// How the (x, y, theta) that drive_arc() returns change, row by row [m, m, rad].
struct ArcJacobians {
  Eigen::Matrix<double, 3, 2> darc_dcontrol;  ///< with (ticks, measured steering [rad])
  /// With (wheelbase [m], driving_scale [m], steer offset of this driving direction [rad]).
  Eigen::Matrix3d darc_dparams;
};

/// Of one call of drive_arc(); smooth through straight lines. At 0 ticks, where (2.6) jumps, the
/// offset is the backward one.
ArcJacobians arc_jacobians(const TricycleParams& params, double ticks, double steering);

/// The measured steering at both ends of a step, changing evenly in between [rad].
struct SteeringSweep {
  double before = 0.0;  ///< alpha_(k-1)
  double after = 0.0;   ///< alpha_k
};

/// A step of second-order Runge-Kutta while the steering changes, seen from where it began: (5.8)
/// to (5.11). From a pose q it leads to q * drive_rk2(...). v_k there is the speed of the driven
/// wheel: Delta t v_k is driving_scale * ticks. Against evenly changing steering its error is of
/// third order in the ticks. Steering beyond a half turn must not be wrapped within a sweep.
Pose2 drive_rk2(const TricycleParams& params, double ticks, const SteeringSweep& steering);

}  // namespace falko_slam
