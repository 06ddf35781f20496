// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/common/time.hpp"
#include "falko_slam/localization/landmark.hpp"
#include "falko_slam/localization/line_model.hpp"
#include "landmark_state.hpp"

namespace falko_slam {

/// A point or a face as the laser saw it. Points in Cartesian coordinates.
struct SeenFeature {
  bool is_line = false;
  LandmarkKind kind = LandmarkKind::kFeature;
  std::optional<std::uint32_t> id;  // of a landmark of the map
  LineObservation line;  // of a point: value and covariance are its x, y; middle is the point
  Eigen::Vector2d in_map = Eigen::Vector2d::Zero();  // its middle, from the present pose
};

/// Empty for an observation that is_usable() refuses.
std::optional<SeenFeature> seen_point(const LandmarkObservation& observation);
std::optional<SeenFeature> seen_line(const LineObservation& observation);

/// What the state does not hold of its landmarks.
struct FeatureRecord {
  std::uint64_t number = 0;
  bool is_line = false;
  LandmarkKind kind = LandmarkKind::kFeature;
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // of a line
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  // of a line, as it was seen last, in map
  double half_length = 0.0;
  Time last_seen{};
};

/// A landmark's row for the observation of it, the state's pose and landmark being these.
LandmarkState::Row row_of(const Pose2& map_T_base, const Pose2& base_T_laser,
                          const FeatureRecord& record, const Eigen::Vector2d& mean,
                          const SeenFeature& seen);

/// The same of a landmark of the map, which is not in the state.
LandmarkState::Row row_of(const Pose2& map_T_base, const Pose2& base_T_laser,
                          const Landmark& landmark, const SeenFeature& seen);

/// The landmark that is seen so, and how it hangs on pose and observation.
struct BornLandmark {
  Eigen::Vector2d mean;
  Eigen::Matrix<double, 2, 3> dlandmark_dpose;
  Eigen::Matrix2d noise;
};
BornLandmark born(const Pose2& map_T_base, const Pose2& base_T_laser, const SeenFeature& seen);

/// Whether two stretches of a face have a part in common along it. `angle`: of the normal, in map.
bool overlap(double angle, const Eigen::Vector2d& middle, double half_length,
             const Eigen::Vector2d& other_middle, double other_half_length);

}  // namespace falko_slam
