// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/localization/landmark_map.hpp"

namespace falko_slam {

constexpr int kMostLandmarkId = 1000000000;
constexpr int kMostLayer = 65535;
constexpr double kFarthestLandmark = 1e5;  ///< of a coordinate [m]

inline const EnumNames<LandmarkKind>& landmark_kind_names() {
  static const EnumNames<LandmarkKind> names = {{"reflector", LandmarkKind::kReflector},
                                                {"feature", LandmarkKind::kFeature}};
  return names;
}

/// Symmetric and positive semidefinite.
bool is_covariance(const Eigen::Matrix2d& covariance);

/// Throws std::invalid_argument, "hits = -1: must be in [0, 1000000000]".
void validate(const MapLandmark& landmark);

}  // namespace falko_slam
