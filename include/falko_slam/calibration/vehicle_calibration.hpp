// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// Whether both directions share one steer offset, \cite kallasi2017, 2.1.1 and 2.1.2.
enum class TricycleModel { kStandard, kAsymmetric };

/// All that a calibration may find out about a tricycle and its laser.
struct VehicleCalibration {
  TricycleParams tricycle;
  double steer_gain = 1.0;  ///< what the measured steering is multiplied with, before the offset
  Pose2 base_T_laser;       ///< l
};

/// The order of the components of a parameter vector and of its covariance.
enum class CalibrationParameter : std::size_t {
  kSteerOffsetForward,   ///< alpha_F [rad]
  kSteerOffsetBackward,  ///< alpha_B [rad]
  kDrivingScale,         ///< s_w [m/tick]
  kLaserX,               ///< l_x [m]
  kLaserY,               ///< l_y [m]
  kLaserTheta,           ///< l_theta [rad]
  kWheelbase,            ///< L [m]
  kSteerGain,            ///< 1
};
constexpr std::size_t kCalibrationParameters = 8;
constexpr std::size_t index_of(CalibrationParameter parameter) {
  return static_cast<std::size_t>(parameter);
}
using CalibrationVector = Eigen::Matrix<double, kCalibrationParameters, 1>;
using CalibrationMatrix = Eigen::Matrix<double, kCalibrationParameters, kCalibrationParameters>;

/// "steer_offset_forward", as in files.
const char* name_of(CalibrationParameter parameter);

CalibrationVector vector_of(const VehicleCalibration& calibration);
VehicleCalibration calibration_of(const CalibrationVector& vector);

}  // namespace falko_slam
