// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>

#include "falko_slam/simulation/driver.hpp"

namespace falko_slam {

/// Leads a vehicle by commands that come while it drives: the last one counts until it is older
/// than the time-out, then the vehicle halts. command() may be called from any thread.
class CommandedDriver : public Driver {
 public:
  explicit CommandedDriver(Duration timeout) : timeout_(timeout) {}

  /// Throws std::invalid_argument unless the command is finite; then the last one stays.
  void command(const WheelCommand& command, Time now);

  /// Never over.
  std::optional<DriveInput> next(const SimulatedVehicle& vehicle, Duration period) override;

  /// A command is in force.
  bool is_led(Time now) const;

 private:
  struct Received {
    WheelCommand command;
    Time time{};
  };
  std::optional<WheelCommand> in_force(Time now) const;

  Duration timeout_;
  mutable std::mutex mutex_;
  std::optional<Received> last_;
};

}  // namespace falko_slam
