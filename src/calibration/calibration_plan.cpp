// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_plan.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void validate(const CalibrationPlan& plan) {
  require_in_range("arcs_per_phase", plan.arcs_per_phase, 2, 100);
  require_in_range("min_steering", plan.min_steering, 0.05, 1.5);
  require_in_range("max_steering", plan.max_steering, plan.min_steering + 0.02, 1.5);
  require_in_range("turn", plan.turn, 0.2, kTwoPi);
  require_in_range("wheel_speed", plan.wheel_speed, 0.05, 5.0);
  require_in_range("rest", plan.rest, 0.5, 60.0);
  require_in_range("max_distance", plan.max_distance, 1e-3, 1000.0);
}

std::vector<PlannedArc> arcs_of(const CalibrationPlan& plan) {
  std::vector<PlannedArc> arcs;
  for (const DrivePhase phase : kAllDrivePhases) {
    const bool left = phase == DrivePhase::kForwardLeft || phase == DrivePhase::kBackwardLeft;
    for (int i = 0; i < plan.arcs_per_phase; ++i) {
      const double share = static_cast<double>(i) / (plan.arcs_per_phase - 1);
      const double steering = plan.min_steering + share * (plan.max_steering - plan.min_steering);
      arcs.push_back({phase, left ? steering : -steering,
                      is_forward(phase) ? plan.wheel_speed : -plan.wheel_speed});
    }
  }
  return arcs;
}

PlannedWay way_of(const CalibrationPlan& plan, const TricycleParams& tricycle) {
  constexpr int kPieces = 36;
  PlannedWay way;
  Pose2 here;
  way.poses.push_back(here);
  for (const PlannedArc& arc : arcs_of(plan)) {
    const double length = plan.turn * tricycle.wheelbase / std::abs(std::sin(arc.steering));
    const double ticks = std::copysign(length / tricycle.driving_scale, arc.wheel_speed);
    for (int i = 0; i < kPieces; ++i) {
      here = here * drive_arc(tricycle, ticks / kPieces, arc.steering);
      way.poses.push_back(here);
      way.greatest_distance = std::max(way.greatest_distance, here.translation().norm());
    }
    way.ends.push_back(here);
    way.seconds += length / plan.wheel_speed + plan.rest;
  }
  return way;
}

}  // namespace falko_slam
