// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/vehicle_calibration.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace test {

/// What a laser on this vehicle sees of an arc, without any noise.
inline PathSegment exact_segment(const VehicleCalibration& vehicle, double ticks, double steering) {
  const double measured = steering * vehicle.steer_gain;
  const Pose2 base_motion = drive_arc(vehicle.tricycle, ticks, measured);
  const double turn = vehicle.tricycle.driving_scale * ticks *
                      std::sin(true_steering(vehicle.tricycle, measured, ticks)) /
                      vehicle.tricycle.wheelbase;
  PathSegment segment{ticks, steering, {}, 0.0};
  segment.start_T_end.pose = vehicle.base_T_laser.inverse() * base_motion * vehicle.base_T_laser;
  segment.start_T_end.covariance = pose_covariance(0.003, 2e-4);
  segment.turn = unwrapped_turn(segment.start_T_end.pose.theta(), turn);
  return segment;
}

/// Arcs of this angle [rad] in all four phases, |steering| evenly from min to max.
struct ArcPlan {
  int arcs_per_phase = 4;
  double min_steering = degrees_to_radians(18.0);
  double max_steering = degrees_to_radians(50.0);
  double turn = kPi;
};

inline std::vector<PathSegment> exact_segments(const VehicleCalibration& vehicle,
                                               const ArcPlan& plan = {}) {
  std::vector<PathSegment> segments;
  for (const DrivePhase phase : kAllDrivePhases) {
    const bool left = phase == DrivePhase::kForwardLeft || phase == DrivePhase::kBackwardLeft;
    for (int i = 0; i < plan.arcs_per_phase; ++i) {
      const double share = i / std::max(1.0, plan.arcs_per_phase - 1.0);
      const double steering = plan.min_steering + share * (plan.max_steering - plan.min_steering);
      const double ticks = plan.turn * vehicle.tricycle.wheelbase /
                           (vehicle.tricycle.driving_scale * std::sin(steering));
      segments.push_back(
          exact_segment(vehicle, is_forward(phase) ? ticks : -ticks, left ? steering : -steering));
    }
  }
  return segments;
}

/// A CB16, the vehicle of \cite kallasi2017, 5.2.1 [m, rad].
inline VehicleCalibration cb16() {
  return {{1.358, 2.4975e-4, degrees_to_radians(-0.72), degrees_to_radians(-0.78)},
          1.0,
          {0.389, 0.0025, degrees_to_radians(0.41)}};
}

/// Any tricycle with a laser anywhere on it.
inline VehicleCalibration random_vehicle(std::mt19937_64& random) {
  VehicleCalibration vehicle;
  vehicle.tricycle = {uniform(random, 0.5, 3.0), uniform(random, 1e-5, 1e-2),
                      uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1)};
  vehicle.base_T_laser = {uniform(random, -2.0, 2.0), uniform(random, -1.0, 1.0),
                          uniform(random, -kPi, kPi)};
  return vehicle;
}

}  // namespace test
}  // namespace falko_slam
