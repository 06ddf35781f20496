// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "falko_slam/evaluation/error_summary.hpp"
#include "falko_slam/geometry/trajectory.hpp"

namespace falko_slam {

struct TrajectoryErrorParams {
  double max_gap = 1.0;   ///< between two true poses that one is interpolated from [s], [0, 1000]
  double distance = 1.0;  ///< of way between the poses that `relative` compares [m], [0.001, 1000]
};
void validate(const TrajectoryErrorParams& params);

struct TrajectoryErrors {
  Pose2 truth_T_map;        ///< brings the estimated positions nearest to the true ones
  PoseErrors absolute;      ///< of the poses after that, \cite sturm2012
  PoseErrors relative;      ///< of the motion along `distance`, from each pose
  std::size_t missing = 0;  ///< poses of a time for which there is no truth
};

/// How far a trajectory is from the true one.
///
/// Truth is taken at the stamps of the estimated poses. The two frames are brought together by
/// the rigid motion with the least sum of squared distances (`align`), so that only the shape
/// counts. Throws std::runtime_error if fewer than two poses have a truth or all of them lie in one
/// place.
TrajectoryErrors evaluate_trajectory(const Trajectory& estimated, const Trajectory& truth,
                                     const TrajectoryErrorParams& params = {});

}  // namespace falko_slam
