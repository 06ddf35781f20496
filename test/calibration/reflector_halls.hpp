// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "falko_slam/calibration/reflector_motion_estimator.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace test {

/// Reflectors around the origin, 8 to 20 m away.
inline ReflectorPoints reflector_hall(std::size_t count, std::mt19937_64& random) {
  ReflectorPoints hall;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        6.28 * (static_cast<double>(i) + uniform(random, 0.0, 0.6)) / static_cast<double>(count);
    const double distance = uniform(random, 8.0, 20.0);
    hall.push_back(distance * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return hall;
}

/// What a laser sees of them; ranges too short by `offset`.
inline ReflectorPoints seen_from(const ReflectorPoints& hall, const Pose2& world_T_laser,
                                 double noise, std::mt19937_64& random, double offset = 0.0) {
  ReflectorPoints seen;
  for (const Eigen::Vector2d& reflector : hall) {
    Eigen::Vector2d point = world_T_laser.inverse() * reflector;
    point *= 1.0 - offset / point.norm();
    seen.push_back(point + Eigen::Vector2d(normal(random, noise), normal(random, noise)));
  }
  return seen;
}

/// A drive along an arc of this tangent, with eight scans at rest at both ends and 40 between. The
/// encoders lead with an error of this share.
inline ReflectorMotionEstimator driven(const ReflectorPoints& hall, const Eigen::Vector3d& arc,
                                       double noise, std::mt19937_64& random,
                                       double share_of_error = 0.03, double offset = 0.0) {
  constexpr int kScans = 40;
  ReflectorMotionEstimator estimator;
  for (int i = 0; i < 8; ++i) {
    estimator.add_at_start(seen_from(hall, {}, noise, random, offset));
  }
  const Pose2 believed = Pose2::exp((1.0 + share_of_error) / kScans * arc);
  for (int i = 1; i < kScans; ++i) {
    const Pose2 here = Pose2::exp(static_cast<double>(i) / kScans * arc);
    estimator.add_on_the_way(seen_from(hall, here, noise, random, offset), believed);
  }
  for (int i = 0; i < 8; ++i) {
    estimator.add_at_end(seen_from(hall, Pose2::exp(arc), noise, random, offset), believed);
  }
  return estimator;
}

}  // namespace test
}  // namespace falko_slam
