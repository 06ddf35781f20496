// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// What a calibration drives, \cite kallasi2017, 5.2.1: four phases (forward and backward, left and
/// right) of arcs that turn by beta, each with a greater |alpha| than the one before.
struct CalibrationPlan {
  int arcs_per_phase = 6;           ///< n_seg, [2, 100]
  double min_steering = 0.314;      ///< least |alpha| as measured [rad], [0.05, 1.5]
  double max_steering = 0.873;      ///< greatest |alpha| [rad], (min_steering, 1.5]
  double turn = 3.141592653589793;  ///< beta [rad], [0.2, 6.2831853]
  double wheel_speed = 1.0;         ///< v_w [m/s], [0.05, 5]
  double rest = 2.0;                ///< halt at the end of each arc [s], [0.5, 60]
  /// How far base_link may be from where it started [m], (0, 1000]: the free area, less the
  /// vehicle.
  double max_distance = 12.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationPlan& plan);

/// An arc of the plan.
struct PlannedArc {
  DrivePhase phase = DrivePhase::kForwardLeft;
  double steering = 0.0;     ///< [rad], positive to the left
  double wheel_speed = 0.0;  ///< [m/s], negative backwards
};

/// All arcs in the order in which they are driven: forward left, forward right, backward left,
/// backward right.
std::vector<PlannedArc> arcs_of(const CalibrationPlan& plan);

/// Where an ideal vehicle would go, for a first check of the area and for pictures: base_link seen
/// from the start, and the greatest distance on the way [m].
struct PlannedWay {
  std::vector<Pose2> poses;  ///< about every 5 degrees of an arc, from the start on
  std::vector<Pose2> ends;   ///< after each arc
  double greatest_distance = 0.0;
  double seconds = 0.0;  ///< driving and resting; without acceleration and steering
};
PlannedWay way_of(const CalibrationPlan& plan, const TricycleParams& tricycle);

}  // namespace falko_slam
