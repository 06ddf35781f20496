// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "falko_slam/calibration/wall_scan.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

struct WallRegistrationParams {
  double first_gate = 0.3;  ///< distance of walls that are paired up to begin with [m], [0.001, 10]
  double last_gate = 0.05;  ///< and to end with [m], [0.001, 10]
  double max_angle = 0.1;   ///< between the directions of paired walls [rad], [0.001, 1]
  /// Standard deviation of how far a part of a wall lies beside where it is, seen from one place,
  /// whatever the number of scans: footprints at a slant, what is no plane [m], [0, 1].
  double lasting_noise = 0.0005;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const WallRegistrationParams& params);

/// Standard deviation of a pose's position in its worst direction [m].
double greatest_deviation(const Eigen::Matrix3d& covariance);

/// Where a scan was taken, seen from where another one was.
struct WallRegistration {
  Pose2 target_T_source;
  /// What the walls say of x, y [m] and theta [rad], target frame, without the prior.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Covariance with the prior, and what of it is due to lasting noise.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d lasting_covariance = Eigen::Matrix3d::Zero();
  /// Standard deviation of the position in its worst direction without the part of a wall that is
  /// needed most [m]: what hangs on a single part may be a mistaken one.
  double deviation_without_a_part = 0.0;
  double agreeing_length = 0.0;       ///< of wall that both see alike [m]
  double contradicting_length = 0.0;  ///< of wall that is elsewhere, or seen through [m]
  std::size_t parts = 0;              ///< of walls that are paired
  double chi2_per_freedom = 0.0;      ///< of the parts' distances
  double rms_residual = 0.0;          ///< of the pieces' distances [m]

  double agreement() const {
    const double length = agreeing_length + contradicting_length;
    return length > 0.0 ? agreeing_length / length : 0.0;
  }
};

/// The motion that lays the straight walls of one scan over those of another one, from an initial
/// pose near it:
///
///     r_i = n_i . (target_T_source p_i - q_i),   cov(r) = D + 2 lasting_noise^2 1 1^T  for each
///     part
///
/// with p_i, q_i the same half metre of wall in both scans and n_i the mean of both walls' normals;
/// both scans count alike, so what is not quite straight errs in both. D is what the scatter of the
/// beams about their walls says. `prior` is the information of the initial pose. What errors of the
/// normals feign of the way along a corridor is taken off. Parts that do not fit
/// (99.99 % of chi2) are left out one by one, the rest may make the covariance greater, beyond
/// chance, and never less. Empty if walls and prior leave a direction open.
std::optional<WallRegistration> register_walls(const WallScan& target, const WallScan& source,
                                               const Pose2& initial, const Eigen::Matrix3d& prior,
                                               const WallRegistrationParams& params = {});

}  // namespace falko_slam
