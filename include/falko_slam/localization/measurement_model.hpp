// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/localization/landmark.hpp"

namespace falko_slam {

/// h of (5.14) and how it changes, row by row of the observation.
struct ObservationPrediction {
  Eigen::Vector2d value;
  Eigen::Matrix<double, 2, 3> dvalue_dpose;  ///< H of (5.16): with (x, y, theta) of map_T_base
  Eigen::Matrix2d dvalue_dlandmark;          ///< with the position in map
};

/// What the laser at base_T_laser should see of a point. With p = landmark, q = (x, y) and theta of
/// map_T_base, t = q + R(theta) l the place of the laser and d = p - t (\cite kallasi2017 (5.14)
/// measures d from q: see doc/decisions/0020-localization-filter.md):
///
///     kCartesian      z = R(theta + theta_l)^T d
///     kRangeBearing   z = (|d|, atan2(d_y, d_x) - theta - theta_l), the bearing in [-pi, pi)
///
/// The range must not be zero for the latter, whose bearing then has no derivative.
ObservationPrediction predict_observation(ObservationModel model, const Pose2& map_T_base,
                                          const Pose2& base_T_laser,
                                          const Eigen::Vector2d& landmark);

/// observed - predicted, the bearing the shorter way round.
Eigen::Vector2d innovation_of(ObservationModel model, const Eigen::Vector2d& observed,
                              const Eigen::Vector2d& predicted);

}  // namespace falko_slam
