// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/features/face_detector.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// A straight face as the laser sees it: the points p with n(angle) . p = offset, n the unit normal
/// that leads from the laser to the face.
struct LineObservation {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();       ///< (angle [rad], offset [m])
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< positive definite
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();      ///< of what was seen of it, in laser [m]
  double half_length = 0.0;                              ///< [m]
};

/// Of a face that was found in a scan.
LineObservation observation_of(const DetectedFace& face);

/// All finite, an offset and a half length above zero, a positive definite covariance.
bool is_usable(const LineObservation& observation);

/// A face of the map: n(angle) . (p - anchor) = offset. The anchor is a place near it that is known
/// by definition: about the map's far origin angle and offset would be all but one number.
struct MapLine {
  double angle = 0.0;   ///< of the normal [rad]
  double offset = 0.0;  ///< [m]
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();
};

/// Along the line, its normal to the left; a unit vector.
Eigen::Vector2d direction_of(const MapLine& line);

Eigen::Vector2d nearest_point(const MapLine& line, const Eigen::Vector2d& to);

/// What a line observation should be and how it changes, (angle, offset) row by row.
struct LinePrediction {
  Eigen::Vector2d value;                     ///< the angle in [-pi, pi)
  Eigen::Matrix<double, 2, 3> dvalue_dpose;  ///< with (x, y, theta) of map_T_base
  Eigen::Matrix2d dvalue_dline;              ///< with (angle, offset) of the map's line
};

/// With t, theta_t the pose of the laser in the map: (angle - theta_t, offset - n . (t - anchor)).
LinePrediction predict_line(const Pose2& map_T_base, const Pose2& base_T_laser,
                            const MapLine& line);

/// The line of the map that is seen so, its anchor at the laser.
MapLine line_in_map(const Pose2& map_T_base, const Pose2& base_T_laser,
                    const LineObservation& observation);

}  // namespace falko_slam
