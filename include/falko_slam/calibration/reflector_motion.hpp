// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/geometry/alignment.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// The motion of a laser from one halt to the next.
struct ReflectorMotion {
  PoseEstimate start_T_end;
  double turn = 0.0;             ///< with its whole turns [rad]
  double rms_residual = 0.0;     ///< of the reflectors at both ends [m]
  std::vector<PointPair> pairs;  ///< what was seen at both ends; target: start, source: end
  std::size_t scans = 0;         ///< in all
};

/// The motion that lays the reflectors of both ends over each other. The weights are inverse
/// variances [1/m^2]; residuals may make the covariance greater, beyond chance, and never less.
/// Empty if they do not determine it.
std::optional<ReflectorMotion> motion_of(std::vector<PointPair> pairs);

/// A reflector that is half hidden from one of the ends is not where it was: the worst pair is left
/// out until all agree (99.99 % of chi2), or no more than `least` are left.
void drop_outliers(std::vector<PointPair>& pairs, std::size_t least);

}  // namespace falko_slam
