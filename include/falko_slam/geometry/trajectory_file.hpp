// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/geometry/trajectory.hpp"

namespace falko_slam {

// The format of the TUM benchmark, \cite sturm2012: `timestamp tx ty tz qx qy qz qw` on each line,
// comments behind #. In the order of the trajectory.

/// Stamps with all nine digits, poses to 1e-9 m and rad: what is written is read as the same text
/// again.
std::string tum_text(const Trajectory& trajectory);

/// Writes the whole file or nothing. Throws std::runtime_error that names the file.
void write_tum(const std::string& path, const Trajectory& trajectory);

/// Takes x, y and the yaw of poses in space. Plain, .gz or .bz2. Throws std::runtime_error that
/// names the file and the line.
Trajectory read_tum(const std::string& path);

/// "1216.630413" exactly, digits below the nanosecond rounded; empty unless it is a time within 285
/// years of zero.
std::optional<Time> time_of(const std::string& seconds);

}  // namespace falko_slam
