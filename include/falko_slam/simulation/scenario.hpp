// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "falko_slam/simulation/laser_model.hpp"
#include "falko_slam/simulation/vehicle_model.hpp"
#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// Stands still.
struct WaitStep {
  double seconds = 1.0;
};

/// Follows straight lines through points of the world, rounding the corners between them; by the
/// true pose, as a vehicle that is led well would.
struct FollowStep {
  std::vector<Eigen::Vector2d> through;  ///< [m]; the vehicle begins where it is
  double speed = 0.8;                    ///< of the wheel [m/s]
  double corner_radius = 1.5;            ///< [m]
  bool backward = false;
  std::string name = {};  ///< of a path whose end is an operation point; empty: of none
  /// Reflectors are out of sight beyond this part of it, for evaluations without them [m].
  double reflectors_until = std::numeric_limits<double>::infinity();
};

/// A constant command, steered to at rest, until the heading has turned or the wheel has gone so
/// far; whichever is given. Nothing corrects it.
struct ArcStep {
  double wheel_speed = 0.5;  ///< negative: backwards [m/s]
  double steering = 0.0;     ///< as the encoder measures it [rad]
  double turn = 0.0;         ///< of the heading, without sign [rad]; 0: not asked for
  double way = 0.0;          ///< of the wheel, without sign [m]; 0: not asked for
};

using DriveStep = std::variant<WaitStep, FollowStep, ArcStep>;

/// A world, a vehicle in it and what it does.
struct Scenario {
  std::string name;
  World world;
  Pose2 world_T_start;
  VehicleModel vehicle;
  LaserModel laser;
  std::vector<DriveStep> drive;  ///< one after the other, with a halt between them
};

}  // namespace falko_slam
