// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/place_recognition/scan_agreement.hpp"
#include "falko_slam/place_recognition/scan_registration.hpp"

namespace falko_slam {

struct ScanLinkParams {
  /// Registration may move the guess by this much. [0, 10] [m], [0, pi] [rad]
  double max_move = 0.5;
  double max_turn = 0.2;
  /// Of the walls that both scans could see this share must agree, seen from either of them, the
  /// agreeing walls must be this long, and this share of the points be in view. [0, 1], [m], [0, 1]
  double min_agreement = 0.6;
  double min_wall = 2.0;
  double min_view = 0.3;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanLinkParams& params);

struct ScanLink {
  PoseEstimate target_T_source;  ///< from the scans alone: a corridor leaves a long ellipse
  double agreement = 0.0;        ///< 0 to 1, the lesser of both directions
};

/// Measures the pose of one scan in another one that it overlaps with. `guess` is a prior for the
/// registration, but does not enter into the result's covariance. Empty if the scans do not agree.
std::optional<ScanLink> link_scans(const ScanView& target, const ScanView& source,
                                   const PoseEstimate& guess, const ScanLinkParams& params = {},
                                   const AgreementParams& agreement = {});

}  // namespace falko_slam
