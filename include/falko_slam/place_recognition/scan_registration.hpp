// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/place_recognition/scan_view.hpp"

namespace falko_slam {

struct RegistrationParams {
  int iterations = 8;  ///< at most [1, 1000]
  /// Distance of points that are paired up to the middle, and from there on. [0.001, 100] [m]
  double first_gate = 0.5;
  double last_gate = 0.15;
  /// Pairs this far apart count by half (Cauchy's loss): of things that have moved there are some
  /// in every scan. 0: all count alike. [0, 100] [m]
  double loss_scale = 0.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const RegistrationParams& params);

struct Registration {
  /// The covariance is of x, y [m] and theta [rad] in the target's frame, the prior included.
  PoseEstimate target_T_source;
  /// What the scans alone say of x, y and theta: (nearly) singular in a corridor without an end.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double rms_residual = 0.0;  ///< of the distances to the lines [m]
  /// Smallest over largest eigenvalue of the normals' scatter, doubled: 1 where walls of all
  /// directions are paired, 0 in a corridor without an end.
  double constraint = 0.0;
};

/// A scan and where it was taken. Borrows the view.
struct PosedView {
  const ScanView* view = nullptr;
  Pose2 target_T_view;
};

/// Point-to-line registration \cite censi2008icp of a scan with the scans that make up the target,
/// from an initial pose; pairs are found along the beams of the target's scans, and each point may
/// have one in each of them.
///
/// `prior` is the information of the initial pose: of x, y [m] and theta [rad], target frame. With
/// one, what an error of the lines' normals feigns is taken off: in a corridor without features the
/// scans say nothing of the way along it. Without one this little is better than nothing.
///
/// Empty if fewer than 10 points are paired, or if these and the prior leave a direction open.
std::optional<Registration> register_scan(const std::vector<PosedView>& target,
                                          const ScanView& source, const Pose2& target_T_source,
                                          const RegistrationParams& params,
                                          const Eigen::Matrix3d& prior = Eigen::Matrix3d::Zero());

/// With a single scan, whose frame is the target's.
std::optional<Registration> register_scans(const ScanView& target, const ScanView& source,
                                           const Pose2& target_T_source,
                                           const RegistrationParams& params = {});

}  // namespace falko_slam
