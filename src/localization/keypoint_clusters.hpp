// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace falko_slam {

/// A keypoint in the map and the viewpoint that saw it.
struct PlacedKeypoint {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< in map [m]
  double variance = 0.0;                            ///< mean of its two axes [m^2]
  std::size_t scan = 0;
  std::size_t viewpoint = 0;
};

/// Keypoints grouped by place: around the densest spot first (that most viewpoints saw), a disc of
/// `radius` [m] is moved to the mean of what it covers until that stays the same, and takes it.
/// What another disc has taken counts no more. Each cluster's keypoints by their places in
/// `keypoints`.
///
/// Works on cells of a quarter of the radius, each as one with the mean of its points: the time
/// does not grow with how often a corner was seen.
std::vector<std::vector<std::size_t>> cluster_keypoints(
    const std::vector<PlacedKeypoint>& keypoints, double radius);

}  // namespace falko_slam
