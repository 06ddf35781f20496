// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "falko_slam/calibration/vehicle_calibration.hpp"
#include "falko_slam/localization/localizer.hpp"
#include "falko_slam/simulation/layout_follower.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"

namespace falko_slam {

/// A halt, and where the vehicle stood in truth.
struct HaltingPoint {
  Halt halt;
  Pose2 world_T_base;
};

/// How a vehicle did on a layout.
struct LayoutDrive {
  std::vector<HaltingPoint> halts;  ///< those that have a name
  std::string trouble;              ///< why it did not come to the end; empty: it did
  double seconds = 0.0;
  std::size_t scans = 0;
  std::array<std::size_t, 4> status{};  ///< scans by LocalizationStatus
  double cross_track_rmse = 0.0;        ///< of the path, by the vehicle's own pose, driving [m]
};

/// What a vehicle on a layout took in.
struct LayoutScan {
  const LocalizerReport& report;  ///< after the scan
  Pose2 world_T_base;             ///< the truth at its stamp
  double seconds = 0.0;           ///< that Localizer::add_scan() took, of the machine's time
};

/// How often, and for how long.
struct LayoutRepetition {
  int rounds = 1;
  double most_seconds = 1e9;  ///< of the vehicle's time; where this is over the drive ends
};

/// A simulated vehicle that drives by what it sees: its encoders and scans go to a Localizer, whose
/// pose leads it along the layout. It takes itself for `believed`, whatever it is. An operator
/// tells it where it stands at the beginning, to 5 cm and one degree. It gives up when it has not
/// known where it is for half a minute.
LayoutDrive drive_layout(
    const Scenario& scenario, const Layout& layout, const VehicleCalibration& believed,
    const LocalizerParams& params, const OdometryNoise& noise, const LandmarkMap& map,
    std::uint64_t seed, const LayoutRepetition& repetition = {},
    const std::function<void(const LayoutScan&)>& observe = [](const LayoutScan&) {},
    const std::function<void(const HaltingPoint&)>& halted = [](const HaltingPoint&) {});

}  // namespace falko_slam
