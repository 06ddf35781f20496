// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "falko_slam/evaluation/layout_drive.hpp"

namespace falko_slam {

/// What a period of a long drive was like; errors are those of the pose after each scan.
struct SoakPeriod {
  double begin = 0.0, end = 0.0;  ///< since the start [s]
  std::size_t scans = 0, ok = 0;  ///< all, and those after which the status was kOk
  std::size_t posed = 0;          ///< those after which there was a pose
  double position_rmse = 0.0, position_max = 0.0;  ///< [m]
  double heading_rmse = 0.0;                       ///< [rad]
  double mean_time = 0.0, max_time = 0.0;          ///< of a scan, of the machine's time [s]
  std::size_t late = 0;                    ///< scans that took longer than until the next one
  std::size_t halts = 0;                   ///< at operation points at the end of a straight way
  double halt_mean = 0.0, halt_max = 0.0;  ///< their distance from the planned point [m]
};

struct SoakParams {
  double hours = 24.0;           ///< of the vehicle's time, (0, 10000]
  double period_minutes = 30.0;  ///< (0, 10000]
  LocalizerParams localizer;
  OdometryNoise odometry;
  std::uint64_t seed = 1;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SoakParams& params);

/// Drives a layout over and over; the vehicle is calibrated as well as CalibrationSpread says.
/// `each` is called when a period is over. Returns why the drive ended early; empty: it did not.
std::string soak(const Scenario& scenario, const Layout& layout, const LandmarkMap& map,
                 const SoakParams& params, const std::function<void(const SoakPeriod&)>& each);

}  // namespace falko_slam
