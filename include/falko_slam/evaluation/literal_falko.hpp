// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct LiteralFalkoParams {
  double radius_scale = 0.20;        ///< a [m]
  double radius_growth = 0.07;       ///< b [1/m]
  double triangle_ratio = 4.0;       ///< beta
  int sectors = 16;                  ///< s_n
  double suppression_radius = 0.20;  ///< [m]
  double refinement_limit = 0.20;    ///< [m]
};

/// FALKO written down as \cite kallasi2017, section 3.1, reads: every point against every other,
/// the score summed over all pairs, corner orientation from the centroids. Slow and plain, to
/// compare `FalkoDetector` with.
///
/// The text leaves open what the sectors are counted from (here: the direction of the beam) and how
/// suppression proceeds (here: greedily, by the distance of the points before refinement).
/// Invalid beams are no points; the scan is taken as open.
std::vector<Keypoint> literal_falko(const LaserScan& scan, const LiteralFalkoParams& params = {});

}  // namespace falko_slam
