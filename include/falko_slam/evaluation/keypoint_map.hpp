// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace falko_slam {

struct KeypointMapParams {
  double association_radius =
      0.05;                  ///< d_max: a keypoint nearer than this belongs to a landmark [m]
  double separation = 0.20;  ///< d_min: one farther than this from all of them is new [m]
};

/// A row of Table 3.1 of \cite kallasi2017.
struct KeypointMapStatistics {
  double landmarks = 0.0;
  double mean_deviation =
      0.0;  ///< mean over landmarks of the root of the eigenvalues' geometric mean [m]
  double max_deviation = 0.0;  ///< mean over landmarks of the root of the greater eigenvalue [m]
  double single_share = 0.0;   ///< landmarks seen once only, of all
};

/// Global stability of keypoints: a map of landmarks is grown from the keypoints of all scans,
/// taken in order, and the scatter of the keypoints of each landmark is measured.
///
/// A keypoint joins the nearest landmark within `association_radius` of its first keypoint; if none
/// is within `separation` it founds one; else it is left out. Eigenvalues are those of the sample
/// covariance (n - 1), of landmarks with at least two keypoints.
KeypointMapStatistics keypoint_map_statistics(
    const std::vector<std::vector<Eigen::Vector2d>>& keypoints_by_scan,
    const KeypointMapParams& params);

/// Mean over `orders` random orders of the scans: which landmark a keypoint joins depends on who
/// came first, and the share of single points with it by some per cent.
KeypointMapStatistics shuffled_keypoint_map_statistics(
    std::vector<std::vector<Eigen::Vector2d>> keypoints_by_scan, const KeypointMapParams& params,
    std::size_t orders, std::size_t seed);

}  // namespace falko_slam
