// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>
#include <vector>

#include "falko_slam/calibration/scan_motion_estimator.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/moving_scans.hpp"
#include "support/scene.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace test {

/// 30 m by 26 m with what stands about in a hall, and a free place of 12 m in its middle.
inline Scene walled_hall() {
  Scene scene;
  scene.add_box({1.0, 0.5, 0.02}, {30.0, 26.0});
  scene.add_box({-9.0, 8.0, 0.3}, {2.4, 1.6});
  scene.add_box({11.0, 6.0, 0.0}, {1.2, 3.0});
  scene.add_box({8.5, -9.0, -0.2}, {3.0, 1.4});
  scene.add_box({-10.5, -7.0, 0.1}, {1.0, 1.0});
  scene.add_box({0.5, 11.0, 0.05}, {4.0, 1.0});
  return scene;
}

/// A laser with a field of view [rad]; the whole circle by default.
inline MovingLaser hall_laser(double noise, double field_of_view = kTwoPi) {
  constexpr std::size_t kBeamsPerTurn = 720;
  MovingLaser result = moving_laser(kBeamsPerTurn, noise);
  if (field_of_view < kTwoPi) {
    result.laser.beams = static_cast<std::size_t>(kBeamsPerTurn * field_of_view / kTwoPi);
    result.laser.angle_min = -0.5 * field_of_view;
  }
  return result;
}

constexpr int kScansAtRest = 6;

inline std::vector<LaserScan> scans_at_rest(const Scene& scene, const Pose2& world_T_laser,
                                            const MovingLaser& laser, std::mt19937_64& random) {
  std::vector<LaserScan> scans;
  for (int i = 0; i < kScansAtRest; ++i) {
    scans.push_back(laser.scan(scene, world_T_laser, {}, random));
  }
  return scans;
}

/// Half a circle of 5 m to the left, as the tangent of its end seen from its start.
inline Eigen::Vector3d half_circle() { return {0.5 * 5.0 * kPi, 0.0, kPi}; }

/// A drive along an arc of this tangent; `start` and `end` are what stands there at its ends. The
/// encoders lead with an error of this share.
struct HallDrive {
  Scene start = walled_hall();
  Scene end = start;
  MovingLaser laser = hall_laser(0.008);
  Pose2 world_T_start{1.0, -2.5, 0.0};
  Eigen::Vector3d arc = half_circle();
  double share_of_error = 0.03;
  int scans_on_the_way = 30;

  ScanMotionEstimator driven(std::mt19937_64& random, const ScanMotionParams& params = {}) const {
    ScanMotionEstimator estimator(params);
    for (const LaserScan& scan : scans_at_rest(start, world_T_start, laser, random)) {
      estimator.add_at_start(scan);
    }
    const Eigen::Vector3d way = arc / (scans_on_the_way + 1);
    const Pose2 believed = Pose2::exp((1.0 + share_of_error) * way);
    for (int i = 1; i <= scans_on_the_way; ++i) {
      // A revolution takes a part of the time from one of these scans to the next.
      constexpr double kSweep = 0.3;
      const Pose2 here = world_T_start * Pose2::exp(i * way);
      const LaserScan scan = laser.scan(start, here, Pose2::exp(kSweep * way), random);
      const Pose2 believed_sweep = Pose2::exp((1.0 + share_of_error) * kSweep * way);
      estimator.add_on_the_way(scan, believed, {believed_sweep, kRevolution});
    }
    for (const LaserScan& scan :
         scans_at_rest(end, world_T_start * Pose2::exp(arc), laser, random)) {
      estimator.add_at_end(scan, believed);
    }
    return estimator;
  }
};

inline Eigen::Vector3d error_of(const Pose2& found, const Pose2& truth) {
  Eigen::Vector3d error;
  error << found.translation() - truth.translation(), angle_between(truth.theta(), found.theta());
  return error;
}

/// Normalised squared error; 3 in the mean if the covariance is right.
inline double squared_error(const PoseEstimate& found, const Pose2& truth) {
  const Eigen::Vector3d error = error_of(found.pose, truth);
  return error.dot(found.covariance.inverse() * error);
}

}  // namespace test
}  // namespace falko_slam
