// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/carmen_log.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// A scan, where the odometry put its laser, and where it stood.
struct DrivenScan {
  LaserScan scan;
  Pose2 odom_T_laser;
  Pose2 map_T_laser;
};

/// The scans of a raw CARMEN log with the truth of a corrected one of the same drive, which has
/// VERTEX2 lines and the same stamps for some of the scans. Between these the truth is the
/// odometry, its error spread over the scans; what comes before the first and after the last of
/// them is left out. `report` tells what the raw log held.
/// Throws std::runtime_error that names the file if one cannot be read, or if fewer than two scans
/// of the raw log are in the corrected one.
std::vector<DrivenScan> load_driven_scans(const std::string& raw, const std::string& corrected,
                                          CarmenReport& report);

}  // namespace falko_slam
