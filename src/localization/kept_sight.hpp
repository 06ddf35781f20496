// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// What a scan says of a place.
enum class PlaceSight {
  kUnknown,      ///< something stands before it, no beam looks there, or they lie too far apart
  kSurface,      ///< a surface is there
  kSeenThrough,  ///< all beams go on behind it
};

/// How far each beam of a scan saw, in little memory.
class KeptSight {
 public:
  KeptSight(const Pose2& map_T_laser, const LaserScan& scan);

  /// Of a disc of `radius` [m] about a place in the map, which beams farther apart than the radius
  /// cannot tell of.
  PlaceSight at(const Eigen::Vector2d& point_in_map, double radius) const;

 private:
  PlaceSight of_beams(double bearing, double half_angle, double near, double far) const;

  Pose2 laser_T_map_;
  double angle_min_;
  double angle_increment_;
  std::vector<float> ranges_;  // NaN where not valid
};

}  // namespace falko_slam
