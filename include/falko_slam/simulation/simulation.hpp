// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "falko_slam/simulation/driver.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"
#include "falko_slam/simulation/reflector_report.hpp"

namespace falko_slam {

/// Where the time of a drive begins that nobody gives another one: 0 is no time in ROS.
inline constexpr Time kSimulationStart{std::chrono::seconds(1)};

/// What a control period brought.
struct SimulationStep {
  EncoderReading encoders;  ///< at its end
  Pose2 world_T_base;       ///< the truth at its end
  /// Scans whose last beam lies in it, with what the device found in them.
  struct Scan {
    SimulatedScan scan;
    std::vector<ReflectorDetection> reflectors;
    Pose2 world_T_base;  ///< the truth when its first beam left
  };
  std::vector<Scan> scans;
};

/// A vehicle with a scanner in a world. The same scenario, seed and inputs give the same results,
/// bit by bit.
class Simulation {
 public:
  /// Throws std::invalid_argument for a scenario that is none. The first scan begins at `start`.
  Simulation(Scenario scenario, Time start, std::uint64_t seed);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// As it is now, without scans: what there is before the first step.
  SimulationStep state() const;

  /// One control period on.
  SimulationStep step(const DriveInput& input);

  const Scenario& scenario() const { return scenario_; }
  const SimulatedVehicle& vehicle() const { return vehicle_; }
  Time time() const { return vehicle_.time(); }
  Duration period() const { return period_; }
  Time start() const { return start_; }

 private:
  Time scan_begin() const;

  Scenario scenario_;
  Time start_;
  Duration period_;
  SimulatedVehicle vehicle_;
  LaserScanner scanner_;
  std::mt19937_64 scan_random_;
  double reflector_diameter_;
  std::int64_t scans_ = 0;
};

}  // namespace falko_slam
