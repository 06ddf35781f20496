// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "falko_slam/simulation/driver.hpp"

namespace falko_slam {

/// A drive that a bag tells of.
struct RecordedDrive {
  std::unique_ptr<Driver> driver;
  std::string description;  ///< one line: topic, type, how many messages
  /// What the counter of the driven wheel began with; of encoders only.
  std::optional<std::uint32_t> first_drive_ticks;
};

/// Reads the drive of a bag: messages of falko_slam/DriveCommand, falko_slam/TricycleEncoders or
/// sensor_msgs/JointState (with the joints of encoder_conversion.hpp). The encoders are taken to
/// count as those of `vehicle` do. An empty topic means the only one of the first of these types
/// that the bag has. Throws std::runtime_error that names the file and lists its topics with their
/// types if there is none, and for messages that cannot be used.
RecordedDrive read_drive(const std::string& bag, const std::string& topic,
                         const VehicleModel& vehicle);

}  // namespace falko_slam
