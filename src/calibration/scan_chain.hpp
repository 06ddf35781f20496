// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "falko_slam/calibration/scan_motion.hpp"

namespace falko_slam {

/// The walls of a scan that others are compared with.
struct WallKey {
  WallScan walls;
  Pose2 start_T_laser;  ///< nearly: as it was tracked
  /// Covariance of what the scan's own motion may feign.
  Eigen::Matrix3d bent = Eigen::Matrix3d::Zero();
};

/// Where the way over some of the keys leads.
struct ChainEnd {
  PoseEstimate start_T_laser;
  Eigen::Matrix3d lasting = Eigen::Matrix3d::Zero();
  WallRegistration last;
  std::size_t links = 0;
};

/// Of one scan's walls with the other's, from where tracking puts them, which counts for nothing
/// beside walls. Empty where fewer than `min_parts` are seen alike.
std::optional<WallRegistration> link(const WallKey& from, const WallKey& to,
                                     const ScanMotionParams& params);

/// From the first key to the last one: of all ways over links that are determined on their own,
/// that of least variance. What first and last see alike, however little, counts as well. Empty if
/// there is no such way. O(keys^2) registrations.
std::optional<ChainEnd> best_chain(const std::vector<WallKey>& keys,
                                   const ScanMotionParams& params);

}  // namespace falko_slam
