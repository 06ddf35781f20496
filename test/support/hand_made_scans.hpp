// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {
namespace test {

constexpr double kNoRange = std::numeric_limits<double>::quiet_NaN();

/// A scan with these ranges; beams whose range is NaN are erroneous.
inline LaserScan scan_of(std::vector<double> ranges, double angle_min, double angle_increment) {
  LaserScan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = angle_increment;
  scan.range_max = 100.0;
  scan.ranges = std::move(ranges);
  for (const double range : scan.ranges) {
    scan.status.push_back(std::isnan(range) ? BeamStatus::kErroneous : BeamStatus::kValid);
  }
  return scan;
}

/// The same over the full circle from -pi.
inline LaserScan circle_of(std::vector<double> ranges) {
  const double increment = kTwoPi / static_cast<double>(ranges.size());
  LaserScan scan = scan_of(std::move(ranges), -kPi, increment);
  scan.closed = true;
  return scan;
}

/// A closed scan of a round room.
inline LaserScan round_scan(double radius, std::size_t beams = 360) {
  return circle_of(std::vector<double>(beams, radius));
}

}  // namespace test
}  // namespace falko_slam
