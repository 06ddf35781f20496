// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Why a scan cannot be used at all.
enum class ScanFault { kNone, kNoBeams, kBadAngles };

/// What became of the beams of one scan: nothing is dropped without being counted here.
struct ScanReport {
  ScanFault fault = ScanFault::kNone;
  std::size_t beam_count = 0;                                ///< as delivered
  std::array<std::size_t, kBeamStatusCount> status_count{};  ///< of the beams kept, by BeamStatus
  std::size_t surplus_beams = 0;         ///< dropped because they repeat bearings of a full turn
  double angle_max_excess = 0.0;         ///< stated minus actual bearing of the last beam, in beams
  bool angle_increment_derived = false;  ///< from angle_min and angle_max: the stated one was 0
  bool time_increment_derived = false;   ///< from scan_time: the stated one was not positive
  std::size_t missing_intensities = 0;   ///< filled with NaN: the array was short, but not empty

  std::size_t count(BeamStatus status) const {
    return status_count[static_cast<std::size_t>(status)];
  }
  bool usable() const { return fault == ScanFault::kNone; }
  /// angle_max lies more than 1.5 increments off: the count of beams and the angles disagree.
  bool angles_disagree() const { return angle_max_excess > 1.5 || angle_max_excess < -1.5; }
};

/// One line for a log, for example
/// "1440 beams: 1391 valid, 49 zero; angle_max is 1.0 beams past the last one".
std::string describe(const ScanReport& report);

}  // namespace falko_slam
