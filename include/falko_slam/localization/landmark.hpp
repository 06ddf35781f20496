// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace falko_slam {

/// Only landmarks and observations of the same kind may belong together.
enum class LandmarkKind {
  kReflector,  ///< its axis, or the middle of its face
  kFeature,    ///< a natural one, such as a corner
};

/// A point of the map that is found again: a reflector or a corner.
struct Landmark {
  std::uint32_t id = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    ///< in map [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the position [m^2]
  LandmarkKind kind = LandmarkKind::kReflector;
};

/// What the two numbers of an observation are, both in the frame of the laser.
enum class ObservationModel {
  kRangeBearing,  ///< (range [m], bearing [rad]), counter-clockwise from the x axis
  kCartesian,     ///< (x [m], y [m])
};

/// A landmark as the laser sees it.
struct LandmarkObservation {
  ObservationModel model = ObservationModel::kCartesian;
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< positive definite
  std::optional<std::uint32_t> id = {};                  ///< if it was recognised
  LandmarkKind kind = LandmarkKind::kReflector;
};

/// All finite, a range above zero, a covariance that is symmetric and positive definite.
bool is_usable(const LandmarkObservation& observation);

/// Where it is in the frame of the laser [m].
Eigen::Vector2d point_in_laser(const LandmarkObservation& observation);

}  // namespace falko_slam
