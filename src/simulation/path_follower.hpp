// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/simulation/scenario.hpp"
#include "falko_slam/simulation/simulated_vehicle.hpp"
#include "rounded_path.hpp"

namespace falko_slam {

/// A wheel that is so near to where it halts is there [m].
inline constexpr double kThere = 0.002;

/// Pure pursuit of a path by base_link, the true pose given.
class PathFollower {
 public:
  PathFollower(const FollowStep& step, const VehicleModel& vehicle, const Pose2& world_T_base);

  /// Empty when the vehicle stands at the end.
  std::optional<WheelCommand> next(const SimulatedVehicle& vehicle);

 private:
  double speed_for(double remaining, double curvature) const;

  FollowStep step_;
  double wheelbase_;
  double acceleration_;
  RoundedPath path_;
  double progress_ = 0.0;  // way on the path [m]
};

/// The fastest from which the way left is enough to brake softly [m/s].
double braking_speed(double remaining, double acceleration);

}  // namespace falko_slam
