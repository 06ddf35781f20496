// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/landmark.hpp"

namespace falko_slam {

/// How far in the map a landmark may lie from where the observation points to, and still pass its
/// gate: an upper bound, so that a search by place misses none.
///
/// The deviation of an innovation in any direction is at most
///
///     sqrt((s_xy + s_theta r)^2 + s_z^2 + s_p^2)
///
/// with the greatest deviations of position, heading, observation and landmark and the distance r
/// of the landmark from base_link, itself at most that of the observed point and the radius.
class GateRadius {
 public:
  /// `gate`: the square root of the greatest Mahalanobis distance squared.
  GateRadius(const PoseEstimate& map_T_base, const Pose2& base_T_laser, double landmark_deviation,
             double gate)
      : base_T_laser_(base_T_laser),
        position_(std::sqrt(greatest(map_T_base.covariance.topLeftCorner<2, 2>()))),
        heading_(std::sqrt(std::max(0.0, map_T_base.covariance(2, 2)))),
        landmark_(landmark_deviation),
        gate_(gate) {}

  double of(const LandmarkObservation& observation) const {
    return observation.model == ObservationModel::kCartesian ? cartesian(observation)
                                                             : polar(observation);
  }

 private:
  static double greatest(const Eigen::Matrix2d& covariance) {
    return std::max(0.0,
                    0.5 * covariance.trace() +
                        std::hypot(0.5 * (covariance(0, 0) - covariance(1, 1)), covariance(0, 1)));
  }

  double cartesian(const LandmarkObservation& observation) const {
    const double way = (base_T_laser_ * observation.value).norm();
    const double here =
        std::hypot(position_ + heading_ * way,
                   std::hypot(landmark_, std::sqrt(greatest(observation.covariance))));
    const double share = 1.0 - gate_ * heading_;
    return share > 0.0 ? gate_ * here / share : std::numeric_limits<double>::infinity();
  }

  double polar(const LandmarkObservation& observation) const {
    const double lever = heading_ * base_T_laser_.translation().norm();
    const double place = std::hypot(position_ + lever, landmark_);
    const double along = gate_ * std::hypot(place, std::sqrt(observation.covariance(0, 0)));
    const double nearest = observation.value.x() - along;
    double turn = kPi;
    if (nearest > 0.0) {
      const double across = (position_ + lever) / nearest + heading_;
      turn = std::min(
          kPi, gate_ * std::hypot(across, std::hypot(landmark_ / nearest,
                                                     std::sqrt(observation.covariance(1, 1)))));
    }
    return along + observation.value.x() * turn;
  }

  Pose2 base_T_laser_;
  double position_, heading_, landmark_, gate_;
};

}  // namespace falko_slam
