// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

struct NearestNeighborParams {
  /// Points farther apart than this under the initial pose are no pair. (0, 100] [m]
  double max_distance = 0.50;
  /// As CorrespondenceGraphParams::orientation_gate; pi: any. [0, pi] [rad]
  double orientation_gate = 1.05;
  double residual_noise = 0.03;  ///< as in CorrespondenceGraphParams [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const NearestNeighborParams& params);

/// Association from a pose that is roughly known, for instance from odometry
/// (\cite kallasi2017 4.1): pairs of points each of which is the other's nearest neighbour under
/// `target_T_source` among those its orientation allows, and the least-squares pose of these pairs.
///
/// Of equally near neighbours the one with the lowest index counts. One step, no iteration: calling
/// it again with the pose it found makes it ICP. Never `proven`: nothing is maximised.
MatchResult match_nearest_neighbors(const std::vector<MatchPoint>& source,
                                    const std::vector<MatchPoint>& target,
                                    const Pose2& target_T_source,
                                    const NearestNeighborParams& params = {});

}  // namespace falko_slam
