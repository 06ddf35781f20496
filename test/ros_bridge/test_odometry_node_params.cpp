// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/odometry_node_params.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "falko_slam/simulation/vehicle_model.hpp"
#include "support/field_values.hpp"
#include "support/refusals.hpp"

namespace falko_slam {
namespace {

std::map<std::string, std::string> values_of(const OdometryNodeParams& params) {
  test::FieldValues values;
  visit_odometry_node_fields(params, values);
  return values.values();
}

OdometryNodeParams read_odometry(const XmlRpc::XmlRpcValue& tree) {
  std::vector<std::string> unknown;
  return read_odometry_node_params(tree, "/odometry", unknown);
}

TEST(ShippedOdometryYaml, HoldsTheDefaultsOfEveryField) {
  const XmlRpc::XmlRpcValue tree =
      read_parameter_file(FALKO_SLAM_SOURCE_DIR "/config/tricycle_odometry.yaml");
  OdometryNodeParams params;
  test::FieldChanger changer;  // whatever the file leaves out would stay changed
  visit_odometry_node_fields(params, changer);
  ParameterReader reader(tree, "~");
  visit_odometry_node_fields(params, reader);

  EXPECT_TRUE(reader.unknown().empty());
  EXPECT_EQ(values_of(params), values_of(OdometryNodeParams()));
}

// What launch/agv.launch gives to all nodelets of a vehicle.
TEST(ShippedVehicleYaml, HoldsTheDefaultsOfAllThatAVehicleIs) {
  const XmlRpc::XmlRpcValue tree =
      read_parameter_file(FALKO_SLAM_SOURCE_DIR "/config/vehicles/tricycle.yaml");
  VehicleParams params;
  test::FieldChanger changer;  // whatever the file leaves out would stay changed
  visit_vehicle_fields(params, changer);
  params.calibration_file.clear();  // the two that are arguments of their own
  params.encoder_source = VehicleParams().encoder_source;
  ParameterReader reader(tree, "~");
  visit_vehicle_fields(params, reader);
  test::FieldValues read, defaults;
  visit_vehicle_fields(params, read);
  const VehicleParams untouched;
  visit_vehicle_fields(untouched, defaults);

  EXPECT_TRUE(reader.unknown().empty());
  EXPECT_EQ(read.values(), defaults.values());
}

// What the simulated vehicle of the launch files is calibrated by.
TEST(ShippedVehicleYaml, CalibrationOfTheSimulatedVehicleIsRight) {
  VehicleParams params;
  params.calibration_file = FALKO_SLAM_SOURCE_DIR "/config/vehicles/simulated.yaml";
  const VehicleCalibration found = calibration_of(params, "");
  const VehicleModel truth;

  EXPECT_NEAR(found.base_T_laser.x(), truth.base_T_laser.x(), 0.001);
  EXPECT_NEAR(found.base_T_laser.y(), truth.base_T_laser.y(), 0.001);
  EXPECT_NEAR(found.base_T_laser.theta(), truth.base_T_laser.theta(), 3e-4);
  EXPECT_NEAR(found.tricycle.driving_scale / truth.tricycle.driving_scale, 1.0, 1e-3);
}

TEST(OdometryNodeParams, GiveWhatTheVehicleIs) {
  XmlRpc::XmlRpcValue tree;
  tree["vehicle"]["wheelbase"] = 1.2;
  tree["vehicle"]["steer_gear"] = 0.1;
  tree["vehicle"]["steer_gain"] = 5.0;
  tree["vehicle"]["laser_x"] = 1.8;
  tree["odom_frame"] = "/odom";
  std::vector<std::string> unknown;
  const OdometryNodeParams params = read_odometry_node_params(tree, "/odometry", unknown);

  EXPECT_EQ(params.calibration.tricycle.wheelbase, 1.2);
  EXPECT_EQ(params.calibration.base_T_laser.x(), 1.8);
  EXPECT_EQ(params.encoders.steer_gain, 0.5);
  EXPECT_EQ(params.odom_frame, "odom");
}

TEST(OdometryNodeParams, AreRefusedByName) {
  XmlRpc::XmlRpcValue tree;
  tree["vehicle"]["drive_ticks_per_turn"] = 0;
  test::expect_refused([&] { read_odometry(tree); }, {"/odometry", "drive_ticks_per_turn = 0"});
  tree = XmlRpc::XmlRpcValue();
  tree["vehicle"]["steer_zero"] = -1;
  test::expect_refused([&] { read_odometry(tree); }, {"/odometry", "steer_zero = -1"});
  tree = XmlRpc::XmlRpcValue();
  tree["noise"]["slip"] = -1.0;
  test::expect_refused([&] { read_odometry(tree); }, {"/odometry", "slip = -1"});
  tree = XmlRpc::XmlRpcValue();
  tree["vehicle"]["steer_gain"] = 3.0;
  test::expect_refused([&] { read_odometry(tree); }, {"/odometry", "steer_gain = 3"});
  tree = XmlRpc::XmlRpcValue();
  tree["base_frame"] = "";
  test::expect_refused([&] { read_odometry(tree); }, {"/odometry", "frames must have names"});
}

}  // namespace
}  // namespace falko_slam
