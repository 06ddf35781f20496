// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

const char* name_of(CalibrationParameter parameter) {
  constexpr std::array<const char*, kCalibrationParameters> kNames = {"steer_offset_forward",
                                                                      "steer_offset_backward",
                                                                      "driving_scale",
                                                                      "laser_x",
                                                                      "laser_y",
                                                                      "laser_theta",
                                                                      "wheelbase",
                                                                      "steer_gain"};
  return kNames[index_of(parameter)];
}

CalibrationVector vector_of(const VehicleCalibration& calibration) {
  const TricycleParams& tricycle = calibration.tricycle;
  const Pose2& laser = calibration.base_T_laser;
  CalibrationVector vector;
  vector << tricycle.steer_offset_forward, tricycle.steer_offset_backward, tricycle.driving_scale,
      laser.x(), laser.y(), laser.theta(), tricycle.wheelbase, calibration.steer_gain;
  return vector;
}

VehicleCalibration calibration_of(const CalibrationVector& vector) {
  return {
      {vector[6], vector[2], vector[0], vector[1]}, vector[7], {vector[3], vector[4], vector[5]}};
}

}  // namespace falko_slam
