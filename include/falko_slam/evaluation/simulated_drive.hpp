// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/vehicle_knowledge.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/geometry/trajectory.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/simulation/scenario.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"

namespace falko_slam {

/// What came in, in the order in which a vehicle sends it.
struct DriveInputEvent {
  Time stamp{};
  std::optional<PoseEstimate> motion;  ///< of base_link since the event before that has one
  std::optional<LaserScan> scan;
};

/// A step of the drive that has a name.
struct DriveLeg {
  std::string name;
  Time begin{}, end{};
  Time reflectors_until{};  ///< when FollowStep::reflectors_until is passed; `end` if it is not
};

/// A simulated drive as a localizer on board gets it.
struct SimulatedDrive {
  std::vector<DriveInputEvent> events;
  Trajectory truth;  ///< base_link in the world at the end of each control period
  std::vector<DriveLeg> legs;
  Pose2 base_T_laser;  ///< as the calibration has it
};

/// Does the scenario's drive for `duration` [s] at most. The odometry's parameters are the true
/// ones with an error drawn from `spread`. `step` is called after each scan.
SimulatedDrive simulate_drive(
    const Scenario& scenario, const CalibrationSpread& spread, const OdometryNoise& noise,
    std::uint64_t seed, double duration, const std::function<void()>& step = [] {});

}  // namespace falko_slam
