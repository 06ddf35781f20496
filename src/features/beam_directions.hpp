// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Unit vectors along the beams, kept as long as scans of the same geometry come in.
class BeamDirections {
 public:
  /// False if nothing had to be done.
  bool assign(const LaserScan& scan) {
    return assign(scan.angle_min, scan.angle_increment, scan.size());
  }

  /// The same for `beams` directions from `angle_min` on.
  bool assign(double angle_min, double angle_increment, std::size_t beams) {
    if (angle_min == angle_min_ && angle_increment == angle_increment_ &&
        beams == directions_.size()) {
      return false;
    }
    angle_min_ = angle_min;
    angle_increment_ = angle_increment;
    directions_.clear();
    for (std::size_t i = 0; i < beams; ++i) {
      const double bearing = angle_min + static_cast<double>(i) * angle_increment;
      directions_.emplace_back(std::cos(bearing), std::sin(bearing));
    }
    return true;
  }

  const Eigen::Vector2d& operator[](std::size_t beam) const { return directions_[beam]; }

 private:
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::vector<Eigen::Vector2d> directions_;
};

}  // namespace falko_slam
