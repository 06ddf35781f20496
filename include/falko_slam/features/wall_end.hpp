// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {

struct WallEndParams {
  /// The range jumps by more than this beside a wall's end. [0.05, 100] [m]
  double min_jump = 0.50;
  /// So many steps from beam to beam behind the end lie on the wall. [1, 100]
  int wall_steps = 3;
  SurfaceStepParams surface;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const WallEndParams& params);

/// The near sides of range jumps: where a wall ends, or is cut off by what stands before it.
///
/// Not as repeatable as corners, since the end of an occluded wall moves with the viewpoint, but
/// many, and each with a direction: `orientation` points along the wall, away from its end.
/// `radius` is the length of wall looked at, `score` and `roughness` are 0. In the order of the
/// beams.
std::vector<Keypoint> find_wall_ends(const LaserScan& scan, const WallEndParams& params = {});

}  // namespace falko_slam
