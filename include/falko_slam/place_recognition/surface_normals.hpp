// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct SurfaceNormalParams {
  /// Side of the square cells. Greater ones tell smoother normals of farther walls. [0.01, 100] [m]
  double cell_size = 0.50;
  /// Cells with fewer points of the scan have no normal. [2, 1000]
  int min_points = 3;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SurfaceNormalParams& params);

/// The normals of the surface at some places of a scan, as GSR takes them (\cite kallasi2017
/// 4.1.1): the points of the scan are collected in a Euclidean grid about the laser; the normal of
/// a cell is the direction in which its points spread least, on the side of the laser.
///
/// Directions in the laser frame, (-pi, pi] [rad]; NaN where the cell has too few points, or
/// spreads alike in all directions. The grid does not turn with the laser: normals of places near
/// the border of a cell change a little with the heading.
std::vector<double> surface_normals(const LaserScan& scan,
                                    const std::vector<Eigen::Vector2d>& places,
                                    const SurfaceNormalParams& params = {});

}  // namespace falko_slam
