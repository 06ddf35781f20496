// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "falko_slam/common/time.hpp"

namespace falko_slam {

/// What a beam tells.
enum class BeamStatus : std::uint8_t {
  kValid,
  kNoReturn,   ///< +Inf of REP-117, or 0 where the parameters say so: nothing was hit
  kZero,       ///< 0 where it may mean too near or too far
  kTooNear,    ///< below range_min, or -Inf
  kTooFar,     ///< above range_max
  kErroneous,  ///< NaN
};
constexpr std::size_t kBeamStatusCount = 6;

/// One revolution (or part of one) of a planar laser scanner, made uniform by `normalize`.
///
/// Frame: the laser, x forward, z up, bearings counter-clockwise from x. Beams are ordered by
/// bearing: `angle_increment` is positive. On a closed scan the last beam is the neighbour of the
/// first one. `ranges`, `status` and, unless it is empty, `intensities` have one entry per beam.
struct LaserScan {
  Time first_beam_time{};          ///< when beam 0 was taken
  Duration time_increment{};       ///< between beam i and i + 1; negative if measured clockwise
  double angle_min = 0.0;          ///< bearing of beam 0 [rad]
  double angle_increment = 0.0;    ///< [rad], positive; 0 for a single beam without one
  double range_max = 0.0;          ///< [m]; 1e5 where the sensor does not tell
  bool closed = false;             ///< covers the full circle
  bool reversed = false;           ///< beam i is beam size() - 1 - i of the message
  std::vector<double> ranges;      ///< [m], NaN unless the beam is valid
  std::vector<BeamStatus> status;  ///< why a range is NaN
  std::vector<float> intensities;  ///< sensor units, NaN where missing; empty if there are none

  std::size_t size() const { return ranges.size(); }
  bool valid(std::size_t beam) const { return status[beam] == BeamStatus::kValid; }
  double bearing(std::size_t beam) const {
    return angle_min + static_cast<double>(beam) * angle_increment;
  }
  /// In the laser frame [m]; NaN unless the beam is valid.
  Eigen::Vector2d point(std::size_t beam) const {
    return ranges[beam] * Eigen::Vector2d(std::cos(bearing(beam)), std::sin(bearing(beam)));
  }
  Time beam_time(std::size_t beam) const {
    return first_beam_time + static_cast<Duration::rep>(beam) * time_increment;
  }
  std::size_t message_index(std::size_t beam) const { return reversed ? size() - 1 - beam : beam; }
};

}  // namespace falko_slam
