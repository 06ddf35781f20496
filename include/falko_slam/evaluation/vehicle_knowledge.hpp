// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "falko_slam/calibration/vehicle_calibration.hpp"
#include "falko_slam/simulation/vehicle_model.hpp"

namespace falko_slam {

/// What a calibration without errors would find of a simulated vehicle.
VehicleCalibration true_calibration(const VehicleModel& vehicle);

/// What its controller takes it for before it is calibrated.
VehicleCalibration nominal_calibration(const VehicleModel& vehicle);

/// How far a vehicle's parameters are from the true ones: standard deviations. Default: those of
/// calibrations of the thesis' vehicles (doc/results.md, Calibration).
struct CalibrationSpread {
  double steer_offset = 1.745e-4;   ///< of each direction [rad]
  double driving_scale = 4e-8;      ///< [m/tick]
  double laser_x = 5e-4;            ///< [m]
  double laser_y = 6e-4;            ///< [m]
  double laser_heading = 1.745e-4;  ///< [rad]
};

/// The true parameters, each with an error of its own.
VehicleCalibration drawn_calibration(const VehicleModel& vehicle, const CalibrationSpread& spread,
                                     std::mt19937_64& random);

}  // namespace falko_slam
