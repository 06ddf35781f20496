// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

/// A FLASER or ROBOTLASER1 line.
struct CarmenScan {
  Time stamp{};                  ///< ipc_timestamp
  double angle_min = 0.0;        ///< [rad]
  double angle_increment = 0.0;  ///< [rad]
  double range_max = 0.0;        ///< [m]; the file's value for "no return" lies above
  std::vector<float> ranges;     ///< [m]
  Pose2 world_T_laser;           ///< odometry in a raw log, the corrected pose in a corrected one
  Pose2 world_T_robot;           ///< ROBOTLASER1: as world_T_laser; FLASER: always odometry

  /// Borrows `ranges`.
  RawScan raw() const;
};

/// An ODOM line.
struct CarmenOdometry {
  Time stamp{};
  Pose2 odom_T_robot;
  double forward_velocity = 0.0;  ///< [m/s]
  double turn_velocity = 0.0;     ///< [rad/s]
};

/// A VERTEX2 line: the corrected pose of the robot for the scan that follows it.
struct CarmenVertex {
  long index = 0;
  Pose2 map_T_robot;
};

using CarmenRecord = std::variant<CarmenScan, CarmenOdometry, CarmenVertex>;

/// What a reader has met so far.
struct CarmenReport {
  std::size_t lines = 0;
  std::size_t scans = 0;
  std::size_t odometry = 0;
  std::size_t vertices = 0;
  std::size_t other = 0;                     ///< comments, parameters, edges, unknown messages
  std::size_t backward_stamps = 0;           ///< scans and odometry earlier than the line before
  std::vector<std::size_t> malformed_lines;  ///< numbers of the lines that were left out, from 1
};

/// Reads a CARMEN log (plain, .gz or .bz2 by its ending) in the order of the file.
///
/// Messages: FLASER, ROBOTLASER1, ODOM and the VERTEX2 of corrected logs; all others are counted
/// and passed over. FLASER lines state no angles: 180 degrees from -90, 1 degree for 180 or 181
/// beams, 0.5 for 360 or 361, else 180 degrees over the beams; their maximum range is that of the
/// PARAM robot_front_laser_max, else 80 m.
///
/// Throws std::runtime_error with the file's name if it cannot be opened or unpacked.
class CarmenLogReader {
 public:
  explicit CarmenLogReader(const std::string& path);
  ~CarmenLogReader();
  CarmenLogReader(CarmenLogReader&&) noexcept;
  CarmenLogReader& operator=(CarmenLogReader&&) noexcept;

  /// Empty at the end of the file. Lines that are cut short or hold no numbers are left out and
  /// listed in the report.
  std::optional<CarmenRecord> next();

  const CarmenReport& report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One line for a log: what was read, what was left out.
std::string describe(const CarmenReport& report);

}  // namespace falko_slam
