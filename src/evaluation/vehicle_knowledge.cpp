// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/vehicle_knowledge.hpp"

namespace falko_slam {

VehicleCalibration true_calibration(const VehicleModel& vehicle) {
  return {vehicle.tricycle, 1.0, vehicle.base_T_laser};
}

VehicleCalibration nominal_calibration(const VehicleModel& vehicle) {
  return {vehicle.nominal, 1.0, vehicle.nominal_base_T_laser};
}

VehicleCalibration drawn_calibration(const VehicleModel& vehicle, const CalibrationSpread& spread,
                                     std::mt19937_64& random) {
  std::normal_distribution<double> error;
  VehicleCalibration drawn = true_calibration(vehicle);
  drawn.tricycle.steer_offset_forward += spread.steer_offset * error(random);
  drawn.tricycle.steer_offset_backward += spread.steer_offset * error(random);
  drawn.tricycle.driving_scale += spread.driving_scale * error(random);
  const Pose2& laser = vehicle.base_T_laser;
  const double x = laser.x() + spread.laser_x * error(random);
  const double y = laser.y() + spread.laser_y * error(random);
  drawn.base_T_laser = {x, y, laser.theta() + spread.laser_heading * error(random)};
  return drawn;
}

}  // namespace falko_slam
