// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// What a laser sees that stands still, from several scans.
struct MeanScan {
  LaserScan scan;            ///< each range is the mean of its beam
  double range_noise = 0.0;  ///< standard deviation of a range of one scan [m]; 0 for one scan
  std::size_t scans = 0;     ///< that it is the mean of
};

/// Beam by beam. A beam that is not valid in half of the scans is not in the mean, and one that
/// scatters five times as much as beams do is not, either: it grazes an edge, or something moves
/// there. Scans of another number of beams than the first one's are left out.
MeanScan mean_of(const std::vector<LaserScan>& scans);

}  // namespace falko_slam
