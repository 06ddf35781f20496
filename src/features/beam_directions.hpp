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
    if (scan.angle_min == angle_min_ && scan.angle_increment == angle_increment_ &&
        scan.size() == directions_.size()) {
      return false;
    }
    angle_min_ = scan.angle_min;
    angle_increment_ = scan.angle_increment;
    directions_.clear();
    for (std::size_t i = 0; i < scan.size(); ++i) {
      directions_.emplace_back(std::cos(scan.bearing(i)), std::sin(scan.bearing(i)));
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
