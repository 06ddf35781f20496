// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/carmen_log.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// A scan and where its laser stood.
struct PosedScan {
  LaserScan scan;
  Pose2 map_T_laser;
};

/// The scans of a CARMEN log with corrected poses: a VERTEX2 line in front of each ROBOTLASER1, or
/// FLASER lines whose laser pose is the corrected one.
///
/// The laser's mount on the robot comes from the two poses in the ROBOTLASER1 line. Scans that
/// cannot be used are left out. `report` tells what the file held.
/// Throws std::runtime_error if the file cannot be read, holds no scan, has VERTEX2 lines for some
/// of its scans only, or no corrected pose at all: without VERTEX2 lines the laser then stands
/// wherever the odometry puts the robot, the mount in front.
std::vector<PosedScan> load_posed_scans(const std::string& path, CarmenReport& report);

}  // namespace falko_slam
