// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "path_follower.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

constexpr double kLookAhead = 0.7;      // [m]
constexpr double kLookAheadTime = 0.4;  // more at speed [s]
constexpr double kMostSideways = 0.6;   // [m/s^2]
constexpr double kCreep = 0.02;         // [m/s]

std::vector<Eigen::Vector2d> from_here(const Pose2& here, const FollowStep& step) {
  std::vector<Eigen::Vector2d> points{here.translation()};
  for (const Eigen::Vector2d& point : step.through) {
    if ((point - points.back()).norm() > 1e-3) points.push_back(point);
  }
  return points;
}

}  // namespace

double braking_speed(double remaining, double acceleration) {
  constexpr double kShare = 0.6;  // of the braking that the vehicle has
  return std::max(kCreep, std::sqrt(2.0 * kShare * acceleration * std::max(0.0, remaining)));
}

PathFollower::PathFollower(const FollowStep& step, const VehicleModel& vehicle,
                           const Pose2& world_T_base)
    : step_(step),
      wheelbase_(vehicle.tricycle.wheelbase),
      acceleration_(vehicle.actuators.acceleration),
      path_(from_here(world_T_base, step), step.corner_radius) {}

double PathFollower::speed_for(double remaining, double curvature) const {
  const double in_curve = std::sqrt(kMostSideways / std::max(1e-3, std::abs(curvature)));
  return std::min({step_.speed, in_curve, braking_speed(remaining, acceleration_)});
}

std::optional<WheelCommand> PathFollower::next(const SimulatedVehicle& vehicle) {
  const Pose2& here = vehicle.world_T_base();
  progress_ = path_.nearest(here.translation(), progress_, progress_ + 1.0);
  const double remaining = path_.length() - progress_;
  const double speed = std::abs(vehicle.wheel_speed());
  if (remaining < kThere) {
    if (speed == 0.0) return std::nullopt;
    return WheelCommand{0.0, vehicle.steering()};
  }
  const double ahead = kLookAhead + kLookAheadTime * speed;
  const Eigen::Vector2d goal = here.inverse() * path_.at(progress_ + ahead);
  const double curvature = 2.0 * goal.y() / goal.squaredNorm();
  const double wanted = speed_for(remaining, curvature);
  return WheelCommand{step_.backward ? -wanted : wanted, std::atan(wheelbase_ * curvature)};
}

}  // namespace falko_slam
