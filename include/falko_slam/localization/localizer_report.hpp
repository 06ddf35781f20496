// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/localization_status.hpp"
#include "falko_slam/localization/pose_history.hpp"

namespace falko_slam {

/// A landmark that was seen, moved to where the laser saw it at LocalizerReport::seen_at.
struct SeenLandmark {
  Eigen::Vector2d in_laser = Eigen::Vector2d::Zero();         ///< [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();       ///< of it [m^2]
  ObservationVerdict verdict = ObservationVerdict::kInvalid;  ///< what the filter did with it
  std::optional<std::uint32_t> id;                            ///< of the map's, where it was used
};

/// How the last scan or report of reflectors agreed with the map.
struct MapAgreement {
  std::size_t used = 0;       ///< observations that corrected the pose
  std::size_t strangers = 0;  ///< observations that fit nothing in the map
  std::size_t expected = 0;   ///< landmarks that should have been seen; with scans only
  std::size_t missed = 0;     ///< of them not seen
  double nis = 0.0;           ///< normalised innovation squared of those used
  int degrees_of_freedom = 0;
};

/// All that a Localizer says. Nothing in it is NaN.
struct LocalizerReport {
  LocalizationStatus status = LocalizationStatus::kLost;
  LocalizationReason reason = LocalizationReason::kNoPose;
  Time stamp{};                            ///< of the pose: that of the last motion
  std::optional<PoseEstimate> map_T_base;  ///< while kOk or kDegraded
  double evidence = 0.0;                   ///< log odds that the pose is right, bounded
  std::size_t hypotheses = 0;              ///< places that are compared while kRecovering

  // Of the last scan or report of reflectors.
  Time seen_at{};  ///< the instant that it was brought to
  InputVerdict input = InputVerdict::kInOrder;
  std::vector<SeenLandmark> seen;
  MapAgreement agreement;
  ReflectorReport reflectors;  ///< of the detector
};

}  // namespace falko_slam
