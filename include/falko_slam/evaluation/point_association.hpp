// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

struct AssociatedPair {
  std::size_t first, second;
};

/// One-to-one pairs of points not farther apart than `radius` [m]: the nearest pair first, then the
/// nearest of what is left.
std::vector<AssociatedPair> associate_greedily(const std::vector<Eigen::Vector2d>& first,
                                               const std::vector<Eigen::Vector2d>& second,
                                               double radius);

std::vector<Eigen::Vector2d> positions(const std::vector<Keypoint>& keypoints,
                                       const Pose2& map_T_laser = {});

/// |pairs| / min(|first|, |second|) of \cite kallasi2017, section 3.3; 0 if `second` is empty.
/// `first` must not be empty: there is nothing to repeat.
double repeatability(const std::vector<Eigen::Vector2d>& first,
                     const std::vector<Eigen::Vector2d>& second, double radius);

}  // namespace falko_slam
