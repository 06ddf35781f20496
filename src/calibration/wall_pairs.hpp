// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "falko_slam/calibration/wall_scan.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// The same piece of wall in both scans.
struct WallPair {
  Eigen::Vector3d gradient;  ///< of the distance, by x, y and theta of the source
  /// The same by the angle of the normal: what of the gradient is feigned if that is off.
  Eigen::Vector3d feigned_gradient;
  double distance = 0.0;        ///< across the wall [m]
  double variance = 0.0;        ///< of it, from the scatter of the beams [m^2]
  double angle_variance = 0.0;  ///< of the normal [rad^2]
  double length = 0.0;          ///< [m]
  std::size_t part = 0;         ///< of the source's walls
};

struct WallPairs {
  std::vector<WallPair> pairs;
  double contradicting_length = 0.0;  ///< of pieces in view that have no pair [m]
};

struct WallGate {
  double distance = 0.3;  ///< [m]
  double angle = 0.1;     ///< [rad]
};

/// Of all pieces of the source that the target sees, too.
WallPairs pair_walls(const WallScan& target, const WallScan& source, const Pose2& target_T_source,
                     const WallGate& gate);

}  // namespace falko_slam
