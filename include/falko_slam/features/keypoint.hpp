// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace falko_slam {

/// A corner found in a laser scan.
struct Keypoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< in the laser frame [m]
  double orientation = 0.0;  ///< into the corner, laser frame, [-pi, pi) (\cite kallasi2017 3.2.3)
  double radius = 0.0;       ///< of the neighbourhood it was judged by [m]
  double score = 0.0;        ///< the detector's own measure, smaller is better
  double roughness = 0.0;    ///< residual of the two fitted sides over the height of the corner
  std::size_t beam = 0;      ///< index in the normalised scan
};

}  // namespace falko_slam
