// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "falko_slam/evaluation/simulated_drive.hpp"
#include "falko_slam/localization/localizer.hpp"

namespace falko_slam {

/// What counts as the right place.
struct RightPose {
  double position = 0.1;  ///< [m]
  double heading = 0.04;  ///< [rad]
};

/// How a localizer did on a drive, from the true first pose on; figures of all reports after a
/// scan.
struct LocalizationRun {
  std::size_t scans = 0, posed = 0;  ///< scans, and those after which there was a pose
  double position_rmse = 0.0;        ///< [m]
  double heading_rmse = 0.0;         ///< [rad]
  double position_max = 0.0, heading_max = 0.0;
  double position_bias_x = 0.0, position_bias_y = 0.0;  ///< mean along and across base_link [m]
  double nees = 0.0;                                    ///< mean per degree of freedom, ideal 1
  double nis = 0.0;                                     ///< the same of innovations
  double landmarks = 0.0;                               ///< used per scan, mean
  std::array<std::size_t, 4> status{};                  ///< scans by LocalizationStatus
  std::array<std::size_t, kLocalizationReasonCount> reasons{};  ///< by LocalizationReason
  std::size_t wrong_ok = 0;                                     ///< kOk, but not the right pose
  double mean_time = 0.0, max_time = 0.0;                       ///< of add_scan() [s]
};

/// `params` but for base_T_laser, which is the drive's.
LocalizationRun evaluate_localization(const SimulatedDrive& drive, LocalizerParams params,
                                      const LandmarkMap& map, const RightPose& right = {});

}  // namespace falko_slam
