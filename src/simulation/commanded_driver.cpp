// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/commanded_driver.hpp"

#include <cmath>
#include <stdexcept>

namespace falko_slam {

void CommandedDriver::command(const WheelCommand& command, Time now) {
  if (!std::isfinite(command.wheel_speed) || !std::isfinite(command.steering)) {
    throw std::invalid_argument("wheel_speed and steering must be finite");
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  last_ = Received{command, now};
}

std::optional<WheelCommand> CommandedDriver::in_force(Time now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_ || now - last_->time > timeout_) return std::nullopt;
  return last_->command;
}

bool CommandedDriver::is_led(Time now) const { return in_force(now).has_value(); }

std::optional<DriveInput> CommandedDriver::next(const SimulatedVehicle& vehicle, Duration) {
  const auto command = in_force(vehicle.time());
  return DriveInput(command.value_or(WheelCommand{0.0, vehicle.steering()}));
}

}  // namespace falko_slam
