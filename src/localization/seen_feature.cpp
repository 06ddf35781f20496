// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "seen_feature.hpp"

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/measurement_model.hpp"

namespace falko_slam {

std::optional<SeenFeature> seen_point(const LandmarkObservation& observation) {
  if (!is_usable(observation)) return std::nullopt;
  SeenFeature seen;
  seen.kind = observation.kind;
  seen.id = observation.id;
  seen.line.value = seen.line.middle = point_in_laser(observation);
  seen.line.covariance = observation.covariance;
  if (observation.model == ObservationModel::kRangeBearing) {
    const Eigen::Vector2d& point = seen.line.value;
    Eigen::Matrix2d dpoint;
    dpoint << point / observation.value.x(), Eigen::Vector2d(-point.y(), point.x());
    seen.line.covariance = dpoint * observation.covariance * dpoint.transpose();
  }
  return seen;
}

std::optional<SeenFeature> seen_line(const LineObservation& observation) {
  if (!is_usable(observation)) return std::nullopt;
  SeenFeature seen;
  seen.is_line = true;
  seen.line = observation;
  return seen;
}

LandmarkState::Row row_of(const Pose2& map_T_base, const Pose2& base_T_laser,
                          const FeatureRecord& record, const Eigen::Vector2d& mean,
                          const SeenFeature& seen) {
  LandmarkState::Row row;
  row.noise = seen.line.covariance;
  if (seen.is_line) {
    const auto prediction =
        predict_line(map_T_base, base_T_laser, {mean.x(), mean.y(), record.anchor});
    row.dpose = prediction.dvalue_dpose;
    row.dlandmark = prediction.dvalue_dline;
    row.innovation = seen.line.value - prediction.value;
    row.innovation.x() = wrap_angle(row.innovation.x());
  } else {
    const auto prediction =
        predict_observation(ObservationModel::kCartesian, map_T_base, base_T_laser, mean);
    row.dpose = prediction.dvalue_dpose;
    row.dlandmark = prediction.dvalue_dlandmark;
    row.innovation = seen.line.value - prediction.value;
  }
  return row;
}

LandmarkState::Row row_of(const Pose2& map_T_base, const Pose2& base_T_laser,
                          const Landmark& landmark, const SeenFeature& seen) {
  LandmarkState::Row row =
      row_of(map_T_base, base_T_laser, FeatureRecord{}, landmark.position, seen);
  row.noise += row.dlandmark * landmark.covariance * row.dlandmark.transpose();
  return row;
}

// A point l = t + R z with dl/dtheta = J (l - q). A line's angle is that in the laser and theta_t;
// its offset, from an anchor that stays where t is now, changes as t moves along the normal.
BornLandmark born(const Pose2& map_T_base, const Pose2& base_T_laser, const SeenFeature& seen) {
  const Pose2 map_T_laser = map_T_base * base_T_laser;
  BornLandmark result;
  if (seen.is_line) {
    const MapLine line = line_in_map(map_T_base, base_T_laser, seen.line);
    const Eigen::Vector2d normal(std::cos(line.angle), std::sin(line.angle));
    const Eigen::Vector2d lever = map_T_laser.translation() - map_T_base.translation();
    result.mean << line.angle, line.offset;
    result.dlandmark_dpose << 0.0, 0.0, 1.0,  //
        normal.x(), normal.y(), normal.y() * lever.x() - normal.x() * lever.y();
    result.noise = seen.line.covariance;
  } else {
    const Eigen::Matrix2d R = map_T_laser.rotation();
    result.mean = map_T_laser * seen.line.value;
    const Eigen::Vector2d lever = result.mean - map_T_base.translation();
    result.dlandmark_dpose << Eigen::Matrix2d::Identity(), Eigen::Vector2d(-lever.y(), lever.x());
    result.noise = R * seen.line.covariance * R.transpose();
  }
  return result;
}

bool overlap(double angle, const Eigen::Vector2d& middle, double half_length,
             const Eigen::Vector2d& other_middle, double other_half_length) {
  const Eigen::Vector2d along(-std::sin(angle), std::cos(angle));
  return std::abs(along.dot(other_middle - middle)) < half_length + other_half_length;
}

}  // namespace falko_slam
