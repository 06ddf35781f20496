// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// r_pos^k: where base_link comes to on the arc of this segment, by (2.9) with the angle that the
/// laser measured. The angle and the steering tell the way, so slip does not enter. Where the arc
/// turns by less than a tenth of a radian the ticks tell the way, for the quotient of two small
/// angles tells nothing.
///
/// Deviation: the text points to (2.8) for the angle; the published laser poses of STC and ATC
/// agree to .01 mm, which only the measured one gives.
Eigen::Vector2d base_displacement(const PathSegment& segment, const TricycleParams& tricycle);

/// The pose of the laser on the vehicle, base_T_laser, in closed form: the minimum of
///
///     E(l) = sum_k |l_pos + R(l_theta) s_pos^k - r_pos^k - R(s_theta^k) l_pos|^2
///
/// over all l, \cite kallasi2017, (2.28) to (2.39). All segments count alike. Empty where there is
/// no one minimum: nothing turns, or all arcs have one centre of rotation.
///
/// Deviation: of the two roots of (2.39), with b = -2 mu_2, the smaller one is the minimum and the
/// other the maximum, wherever the laser is mounted; l_x >= 0 decides nothing.
std::optional<Pose2> calibrate_laser_pose(const std::vector<PathSegment>& segments,
                                          const TricycleParams& tricycle);

}  // namespace falko_slam
