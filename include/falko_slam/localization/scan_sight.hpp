// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// What of a map a scan looks at: tells landmarks that something hides from those that should have
/// been found. Borrows the scan.
class ScanSight {
 public:
  explicit ScanSight(const LaserScan& scan) : scan_(scan) {}

  /// Whether all beams that have a range and pass a point of the laser frame by less than
  /// `half_width` go at least as far as it, up to `margin` [m], and there is one. Not known: false.
  bool reaches(const Eigen::Vector2d& point_in_laser, double half_width, double margin) const;

 private:
  const LaserScan& scan_;
};

}  // namespace falko_slam
