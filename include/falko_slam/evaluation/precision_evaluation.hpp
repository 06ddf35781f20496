// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "falko_slam/calibration/observability.hpp"
#include "falko_slam/evaluation/layout_drive.hpp"
#include "falko_slam/evaluation/simulated_calibration.hpp"

namespace falko_slam {

/// A vehicle of the experiment.
struct PrecisionVehicle {
  std::string name;
  VehicleModel model;
  bool calibrated = true;  ///< else it takes itself for what it was built to be
};

/// The three CB25 of \cite kallasi2017, Table 5.3, Setting 1, with what was estimated of them as
/// the truth, and LGV74 once more as built: no offsets, 0.25 mm a tick, the laser at (1.5, 0, 0).
/// The thesis does not say what the wheelbase of a CB25 is: 1.5 m is taken for it.
std::vector<PrecisionVehicle> thesis_vehicles();

/// How the experiment of \cite kallasi2017, 5.2.2, is done.
struct PrecisionParams {
  /// Of each calibration; here a row of Table 5.2 with the usual number of arcs.
  CalibrationCondition condition{6, 0.314, 0.873, 3.141592653589793, 1.0};
  SimulatedCalibrationParams calibration;  ///< of its vehicle the errors only
  LocalizerParams localizer;
  OdometryNoise odometry;
  std::uint64_t seed = 1;
  int rounds = 1;  ///< of the layout
};

/// What one vehicle did.
struct PrecisionRun {
  PrecisionVehicle vehicle;
  CalibrationVerdict verdict = CalibrationVerdict::kUnobservable;  ///< of a calibrated one
  VehicleCalibration believed;
  LayoutDrive drive;
};

/// Calibrates the vehicle as the action does, each in a hall of its own, then lets it drive the
/// layout in the plant by its own pose. `number`: of the vehicle, for its noise. Without a
/// calibration it does not drive.
PrecisionRun evaluate_precision(const PrecisionVehicle& vehicle, std::size_t number,
                                const Scenario& plant, const Layout& layout, const LandmarkMap& map,
                                const PrecisionParams& params);

/// A halting point as Tables 5.4 and 5.5 have it: in a frame whose origin is the mean of where the
/// calibrated vehicles halted there, the x axis as they should head.
struct LocalHalt {
  std::size_t run = 0;  ///< whose
  std::string point;
  bool after_curve = false;
  double x = 0.0, y = 0.0;  ///< [m]
  double heading = 0.0;     ///< from the planned one [rad]
  double planned = 0.0;     ///< distance from the planned point [m]
  double distance() const;  ///< from the mean [m]
};

/// In the order of the runs. Points that no calibrated vehicle reached are left out.
std::vector<LocalHalt> local_halts(const std::vector<PrecisionRun>& runs);

}  // namespace falko_slam
