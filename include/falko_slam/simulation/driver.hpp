// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "falko_slam/simulation/scenario.hpp"
#include "falko_slam/simulation/simulated_vehicle.hpp"

namespace falko_slam {

using DriveInput = std::variant<WheelCommand, EncoderMotion>;

/// Who leads a simulated vehicle.
class Driver {
 public:
  virtual ~Driver() = default;
  /// For the next control period; nothing: there is no more to do.
  virtual std::optional<DriveInput> next(const SimulatedVehicle& vehicle, Duration period) = 0;
};

/// Does the steps of a scenario, halting after each. Begins at the vehicle's time.
std::unique_ptr<Driver> scenario_driver(std::vector<DriveStep> steps, const VehicleModel& vehicle);

/// Recorded commands, each in force until the next one comes or it is older than the time-out; the
/// first one when the simulation begins. Ends with a halt.
std::unique_ptr<Driver> recorded_commands(std::vector<std::pair<Time, WheelCommand>> commands,
                                          Duration timeout);

/// Recorded encoders, driven evenly from reading to reading; the first one when the simulation
/// begins. Throws std::invalid_argument if their times do not rise.
std::unique_ptr<Driver> recorded_encoders(std::vector<EncoderReading> readings,
                                          const EncoderParams& params);

}  // namespace falko_slam
