// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

/// The state as bytes: letters "FALKOMAP", u32 version; u64 length and the keyframes as
/// `to_bytes(std::vector<KeyframeRecord>)` gives them; u64 count and, for each, the laser's pose as
/// f64 x, y, theta; u64 count and, for each constraint, u64 from and to, f64 x, y, theta, the six
/// upper numbers of the information by rows, u8 kind; u64 count and u64 ids of the fixed nodes; u32
/// CRC-32 of all before it. Numbers little-endian, poses in metres and radians.
std::string to_bytes(const SlamState& state);
/// Throws std::runtime_error with what is wrong: every number is looked at.
SlamState slam_state_from(const std::string& bytes);

/// Writes beside the file and renames: killed at any moment, it leaves the old file or the new one.
/// Throws std::runtime_error that names the file; also if there is nothing to save or the file is
/// there and holds something else.
void save_slam_state(const std::string& path, const SlamState& state);
/// Throws std::runtime_error that names the file and what is wrong with it.
SlamState load_slam_state(const std::string& path);

}  // namespace falko_slam
