// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// Direction and side of an arc, the four phases of \cite kallasi2017, 5.2.1.
enum class DrivePhase { kForwardLeft, kForwardRight, kBackwardLeft, kBackwardRight };
constexpr std::size_t kDrivePhases = 4;
constexpr std::array<DrivePhase, kDrivePhases> kAllDrivePhases = {
    DrivePhase::kForwardLeft, DrivePhase::kForwardRight, DrivePhase::kBackwardLeft,
    DrivePhase::kBackwardRight};

/// "forward left", for reports.
const char* name_of(DrivePhase phase);
bool is_forward(DrivePhase phase);

/// The k-th path segment of \cite kallasi2017, 2.2.1: what the encoders and the laser tell of a
/// drive at one measured steering, from halt to halt.
struct PathSegment {
  double ticks = 0.0;        ///< n_w^k of the driven wheel, negative backwards; not 0
  double steering = 0.0;     ///< alpha^k as measured [rad], positive to the left, (-pi, pi)
  PoseEstimate start_T_end;  ///< s^k: the laser at the end seen from the laser at the start
  double turn = 0.0;         ///< s_theta^k with its whole turns [rad]; half a turn has two names
  /// Of the error of (x, y, turn) with that of the next segment in the list, where both share what
  /// was seen between them; columns: the next one.
  Eigen::Matrix3d covariance_with_next = Eigen::Matrix3d::Zero();
};

/// Throws std::invalid_argument that names the segment by its number (from 1), the field and its
/// value: what is not finite, no ticks, a covariance that is none, also with the next segment, a
/// turn that is not the heading.
void validate(const std::vector<PathSegment>& segments);

/// The side by the measured steering; 0 counts as left.
DrivePhase phase_of(const PathSegment& segment);

/// The heading (wrapped) with the whole turns that bring it nearest to what was turned about [rad].
double unwrapped_turn(double heading, double about);

}  // namespace falko_slam
