// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {

/// A scan as some driver or file delivers it: the fields of sensor_msgs/LaserScan, nothing trusted.
/// The arrays are borrowed and must outlive the call.
struct RawScan {
  Time stamp{};
  double angle_min = 0.0;        ///< [rad]
  double angle_max = 0.0;        ///< [rad]; only compared, `range_count` is the truth
  double angle_increment = 0.0;  ///< [rad]; negative: clockwise
  double time_increment = 0.0;   ///< [s]
  double scan_time = 0.0;        ///< of a revolution [s]
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]; not positive or not finite: unlimited
  const float* ranges = nullptr;
  std::size_t range_count = 0;
  const float* intensities = nullptr;
  std::size_t intensity_count = 0;
};

/// What the sensor driver does not say, or says differently from driver to driver.
struct ScanNormalizerParams {
  /// The beam that the stamp belongs to: the SICK driver stamps the first one, others the last.
  enum class StampAt { kFirstBeam, kMiddleBeam, kLastBeam };
  StampAt stamp_at = StampAt::kFirstBeam;
  /// The scanner hangs with its z axis down: bearings change sign.
  bool upside_down = false;
  /// A range of 0 means "nothing hit". Off: it may as well mean "too near" (SICK NAV350).
  bool zero_is_no_return = false;
  /// Added to every valid range [m].
  double range_offset = 0.0;
  /// Nearer or farther beams are dropped whatever the message allows [m]; 0: as the message says.
  double min_range = 0.0;
  double max_range = 0.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanNormalizerParams& params);

/// The one place where scans are made uniform: ordered counter-clockwise, invalid beams typed, the
/// closed circle recognised, beam times worked out. Writes `scan` (its memory is reused) and
/// returns what happened. If the report is not usable, `scan` is empty.
///
/// A scan is closed when its beams cover the circle to within half an increment; beams beyond a
/// full turn (such as a repeated last one) are dropped.
ScanReport normalize(const RawScan& raw, const ScanNormalizerParams& params, LaserScan& scan);

}  // namespace falko_slam
