// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {

/// What a corner's place is worth. Defaults: a SICK NAV350 (\cite sick2017nav350).
struct KeypointNoise {
  double range_noise = 0.008;     ///< standard deviation of a beam's range. [1e-4, 1] [m]
  double bearing_noise = 3.5e-4;  ///< of its direction. [0, 0.1] [rad]
  double place_noise = 0.006;     ///< of what the detector takes for the corner. [0, 1] [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const KeypointNoise& noise);

/// Covariance of a keypoint's position in the frame of the laser [m^2]: the noise of its beam along
/// and across the sight, and that the corner lies anywhere between its beam and the next one on the
/// same surface, which on a face seen at a grazing angle is far: evenly, d d^T / 12 with d from one
/// point to the other.
Eigen::Matrix2d keypoint_covariance(const LaserScan& scan, const Keypoint& keypoint,
                                    const KeypointNoise& noise,
                                    const SurfaceStepParams& surface = {});

}  // namespace falko_slam
