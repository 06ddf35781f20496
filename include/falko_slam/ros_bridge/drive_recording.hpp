// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

/// A scan of a recorded drive. Borrows the ranges.
struct RecordedScan {
  RawScan raw;
  std::optional<Pose2> odom_T_base;  ///< at the scan's stamp; empty where nothing tells
  Pose2 base_T_laser;                ///< of the laser turned upright
  bool upside_down = false;          ///< the laser hangs with its z axis down
};

struct DriveRecordingParams {
  std::string topic;  ///< of the scans in a bag; empty: the only one of type LaserScan
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  bool use_odometry = true;
};

/// What was read, in words, and how many scans there were without odometry.
struct DriveRecordingReport {
  std::string description;
  std::size_t scans = 0;
  std::size_t without_odometry = 0;
  bool base_known = true;  ///< false: the laser is taken for base_link
};

/// Hands over the scans of a recording in its order, each with the odometry of its stamp: of a ROS
/// bag (ending in .bag) from its tf, of a CARMEN log from its lines. The scan is valid during the
/// call only. Throws std::runtime_error that names the file, and the topics in it where the one
/// asked for is not there.
DriveRecordingReport read_drive(const std::string& path, const DriveRecordingParams& params,
                                const std::function<void(const RecordedScan&)>& use);

}  // namespace falko_slam
