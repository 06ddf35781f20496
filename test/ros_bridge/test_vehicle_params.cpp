// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/vehicle_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/ros_bridge/reflector_conversion.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

TEST(VehicleParams, PutTheLaserWhereTheySay) {
  VehicleParams vehicle;
  vehicle.laser_x = 0.4;
  vehicle.laser_theta = 0.1;
  vehicle.calibration.tricycle.wheelbase = 1.5;
  const VehicleCalibration calibration = calibration_of(vehicle, "");
  EXPECT_EQ(calibration.base_T_laser.x(), 0.4);
  EXPECT_EQ(calibration.base_T_laser.theta(), 0.1);
  EXPECT_EQ(calibration.tricycle.wheelbase, 1.5);
}

TEST(VehicleParams, NameTheCalibrationThatIsMissing) {
  const test::TemporaryFolder folder;
  VehicleParams vehicle;
  vehicle.calibration_file = "agv.yaml";
  try {
    calibration_of(vehicle, folder.path());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(folder.file("agv.yaml")), std::string::npos);
  }
}

TEST(VehicleParams, RefuseEncodersThatCannotCount) {
  VehicleParams vehicle;
  vehicle.drive_ticks_per_turn = 4000;
  vehicle.steer_zero = 12;
  EXPECT_EQ(joints_of(vehicle).drive_ticks_per_turn, 4000U);
  EXPECT_EQ(encoders_of(vehicle).steer_zero, 12U);
  vehicle.steer_ticks_per_turn = -5;
  EXPECT_THROW(encoders_of(vehicle), std::invalid_argument);
  vehicle = {};
  vehicle.drive_ticks_per_turn = 0;
  EXPECT_THROW(joints_of(vehicle), std::invalid_argument);
}

TEST(ReflectorConversion, LeavesOutWhatIsNotFinite) {
  ReflectorArray message;
  message.header.stamp = ros::Time(12, 500000000);
  message.reflectors.resize(3);
  message.reflectors[0].position.x = 2.0;
  message.reflectors[0].time_offset = ros::Duration(0.05);
  message.reflectors[1].position.y = std::nan("");
  message.reflectors[2].position.x = std::numeric_limits<double>::infinity();
  const ReflectorObservation observation = from_message(message);
  EXPECT_EQ(observation.first_beam, Time(std::chrono::milliseconds(12500)));
  ASSERT_EQ(observation.reflectors.size(), 1U);
  EXPECT_EQ(observation.reflectors[0].point, Eigen::Vector2d(2.0, 0.0));
  EXPECT_EQ(observation.reflectors[0].after_first_beam, std::chrono::milliseconds(50));
}

}  // namespace
}  // namespace falko_slam
