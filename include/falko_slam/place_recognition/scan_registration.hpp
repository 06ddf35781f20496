// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/place_recognition/scan_view.hpp"

namespace falko_slam {

struct RegistrationParams {
  int iterations = 8;  ///< at most [1, 1000]
  /// Distance of points that are paired up to the middle, and from there on. [0.001, 100] [m]
  double first_gate = 0.5;
  double last_gate = 0.15;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const RegistrationParams& params);

struct Registration {
  PoseEstimate target_T_source;
  double rms_residual = 0.0;  ///< of the distances to the lines [m]
  /// Smallest over largest eigenvalue of the normals' scatter, doubled: 1 where walls of all
  /// directions are paired, 0 in a corridor without an end.
  double constraint = 0.0;
};

/// Point-to-line registration from an initial pose; pairs are found along the beams of the target.
/// Empty if fewer than 10 points are paired or they leave a direction open.
std::optional<Registration> register_scans(const ScanView& target, const ScanView& source,
                                           const Pose2& target_T_source,
                                           const RegistrationParams& params = {});

}  // namespace falko_slam
