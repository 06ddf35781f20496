// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// What is kept of a keyframe: all that it can be made from again, whatever the parameters.
struct KeyframeRecord {
  Time stamp{};           ///< of the scan's message
  std::size_t drive = 0;  ///< see Keyframe::drive
  Pose2 odom_T_laser;     ///< in the odometry of its drive, at the stamp
  Pose2 base_T_laser;     ///< how the laser is mounted
  LaserScan scan;         ///< without intensities
};

/// The records as bytes, in their order. Ranges are rounded to single precision, intensities left
/// out.
///
/// Layout, numbers little-endian: "FALKOKEY", u32 version, u64 count; for each record i64 stamp
/// [ns], u64 drive, odom_T_laser and base_T_laser as f64 x, y, theta; i64 time of the first beam
/// and i64 time increment [ns], f64 angle_min and angle_increment [rad], f64 range_max [m], u8
/// closed, u8 reversed, u32 beams; for each beam u8 status and, if it is valid, f32 range [m]. At
/// the end u32 CRC-32 of all before it.
std::string to_bytes(const std::vector<KeyframeRecord>& records);

/// Throws std::runtime_error with what is wrong and in which keyframe: every number is looked at.
std::vector<KeyframeRecord> keyframes_from(const std::string& bytes);

/// Writes beside the file and renames. Throws std::runtime_error that names the file; also if there
/// is nothing to save, if what would be written could not be read again, or if the file is there
/// and holds something else than keyframes.
void write_keyframe_file(const std::string& path, const std::vector<KeyframeRecord>& records);

/// Throws std::runtime_error that names the file and what is wrong with it.
std::vector<KeyframeRecord> read_keyframe_file(const std::string& path);

}  // namespace falko_slam
