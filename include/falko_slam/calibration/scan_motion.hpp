// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "falko_slam/calibration/wall_registration.hpp"
#include "falko_slam/calibration/wall_scan.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

struct ScanMotionParams {
  WallScanParams walls;
  WallRegistrationParams registration;
  /// Standard deviation of a range [m], (0, 1]; the scans at rest may tell that it is more.
  double range_noise = 0.01;
  /// The encoders' motion is off by this share of it, [0.001, 1].
  double odometry_share = 0.05;
  /// The same of the motion during a scan, once the turn of the whole way is known, [0, 1].
  double mended_share = 0.005;
  /// Scans on the way are remembered this far from each other [m], [rad]. [0.01, 100], [0.01, pi]
  double key_step = 1.0;
  double key_turn = 0.4;
  std::size_t min_parts = 5;   ///< of walls, in what two scans see alike, [3, 1000]
  double min_agreement = 0.6;  ///< share of the walls in view of both that agree, [0, 1]
  /// A pose whose standard deviation is greater in any direction is not determined, nor is one
  /// where it would be without a single part of a wall [m], [rad]. [1e-6, 10], [1e-6, 1]
  double max_deviation = 0.03;
  double max_turn_deviation = 0.005;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanMotionParams& params);

/// The motion of a laser from one halt to the next.
struct ScanMotion {
  PoseEstimate start_T_end;
  double turn = 0.0;  ///< with its whole turns [rad]
  /// What of the covariance does not average out, WallRegistrationParams::lasting_noise.
  Eigen::Matrix3d lasting_covariance = Eigen::Matrix3d::Zero();
  double rms_residual = 0.0;  ///< of the walls of the last link [m]
  std::size_t parts = 0;      ///< of walls in the last link
  std::size_t links = 1;      ///< registrations in a row; 1: the end with the start itself
  std::size_t scans = 0;      ///< in all
};

}  // namespace falko_slam
