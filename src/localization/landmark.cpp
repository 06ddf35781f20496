// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark.hpp"

#include <cmath>

#include "covariance_check.hpp"

namespace falko_slam {

bool is_usable(const LandmarkObservation& observation) {
  const bool ranged =
      observation.model == ObservationModel::kCartesian || observation.value.x() > 0.0;
  return observation.value.allFinite() && ranged && is_positive_definite(observation.covariance);
}

Eigen::Vector2d point_in_laser(const LandmarkObservation& observation) {
  if (observation.model == ObservationModel::kCartesian) return observation.value;
  const double range = observation.value.x(), bearing = observation.value.y();
  return {range * std::cos(bearing), range * std::sin(bearing)};
}

}  // namespace falko_slam
