// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/line_model.hpp"

#include <cmath>

#include "covariance_check.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

// The face turns about its middle: its offset from the laser changes by how far that lies beside
// the foot of the perpendicular.
LineObservation observation_of(const DetectedFace& face) {
  const Eigen::Vector2d& normal = face.line.normal;
  Eigen::Matrix2d J = Eigen::Matrix2d::Identity();
  J(1, 0) = Eigen::Vector2d(-normal.y(), normal.x()).dot(face.middle);
  return {{std::atan2(normal.y(), normal.x()), face.line.offset},
          J * face.covariance * J.transpose(),
          face.middle,
          face.half_length};
}

bool is_usable(const LineObservation& observation) {
  return observation.value.allFinite() && observation.value.y() > 0.0 &&
         observation.middle.allFinite() && std::isfinite(observation.half_length) &&
         observation.half_length > 0.0 && is_positive_definite(observation.covariance);
}

Eigen::Vector2d direction_of(const MapLine& line) {
  return {std::sin(line.angle), -std::cos(line.angle)};
}

Eigen::Vector2d nearest_point(const MapLine& line, const Eigen::Vector2d& to) {
  const Eigen::Vector2d normal(std::cos(line.angle), std::sin(line.angle));
  return to + (line.offset - normal.dot(to - line.anchor)) * normal;
}

LinePrediction predict_line(const Pose2& map_T_base, const Pose2& base_T_laser,
                            const MapLine& line) {
  const Pose2 map_T_laser = map_T_base * base_T_laser;
  const Eigen::Vector2d normal(std::cos(line.angle), std::sin(line.angle));
  const Eigen::Vector2d along(-normal.y(), normal.x());  // dn/dangle
  const Eigen::Vector2d way = map_T_laser.translation() - line.anchor;
  const Eigen::Vector2d lever = map_T_laser.translation() - map_T_base.translation();
  LinePrediction prediction;
  prediction.value << wrap_angle(line.angle - map_T_laser.theta()), line.offset - normal.dot(way);
  prediction.dvalue_dpose << 0.0, 0.0, -1.0,  //
      -normal.x(), -normal.y(), normal.x() * lever.y() - normal.y() * lever.x();
  prediction.dvalue_dline << 1.0, 0.0,  //
      -along.dot(way), 1.0;
  return prediction;
}

MapLine line_in_map(const Pose2& map_T_base, const Pose2& base_T_laser,
                    const LineObservation& observation) {
  const Pose2 map_T_laser = map_T_base * base_T_laser;
  return {wrap_angle(observation.value.x() + map_T_laser.theta()), observation.value.y(),
          map_T_laser.translation()};
}

}  // namespace falko_slam
