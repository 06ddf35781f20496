// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_node_params.hpp"

#include <gtest/gtest.h>

#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/ros_bridge/calibration_node_fields.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"
#include "support/refusals.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

CalibrationNodeParams read_calibration(XmlRpc::XmlRpcValue tree,
                                       std::vector<std::string>* unknown = nullptr) {
  std::vector<std::string> names;
  return read_calibration_node_params(tree, "/calibration", unknown ? *unknown : names);
}

std::map<std::string, std::string> values_of(const CalibrationNodeParams& params) {
  test::FieldValues values;
  visit_calibration_node_fields(params, values);
  return values.values();
}

TEST(ShippedCalibrationYaml, HoldsTheDefaultsOfEveryField) {
  const XmlRpc::XmlRpcValue tree =
      read_parameter_file(FALKO_SLAM_SOURCE_DIR "/config/calibration.yaml");
  CalibrationNodeParams params;
  ParameterReader reader(tree, "~");
  visit_calibration_node_fields(params, reader);

  EXPECT_TRUE(reader.unknown().empty());
  EXPECT_EQ(values_of(params), values_of(CalibrationNodeParams()));
  test::FieldChanger changer;  // whatever the file leaves out would stay changed
  visit_calibration_node_fields(params, changer);
  ParameterReader again(tree, "~");
  visit_calibration_node_fields(params, again);
  EXPECT_EQ(values_of(params), values_of(CalibrationNodeParams()));
}

TEST(CalibrationNodeParams, AreReadByTheirNames) {
  XmlRpc::XmlRpcValue tree;
  tree["model"] = "standard";
  tree["vehicle"]["encoder_source"] = "joint_states";
  tree["vehicle"]["wheelbase"] = 1.5;
  tree["vehicle"]["laser_y"] = 0.25;
  tree["vehicle"]["steer_ticks_per_turn"] = 4096;
  tree["arcs"]["turn"] = 2.0;
  tree["noise"]["slipp"] = 2.0;
  std::vector<std::string> unknown;
  const CalibrationNodeParams params = read_calibration(tree, &unknown);

  EXPECT_EQ(params.session.calibrator.model, TricycleModel::kStandard);
  EXPECT_EQ(params.vehicle.encoder_source, EncoderSource::kJoints);
  EXPECT_EQ(params.session.driver.tricycle.wheelbase, 1.5);
  EXPECT_EQ(params.session.recorder.tricycle.wheelbase, 1.5);
  EXPECT_EQ(params.session.calibrator.wheelbase, 1.5);
  EXPECT_EQ(params.session.recorder.base_T_laser.y(), 0.25);
  EXPECT_EQ(params.session.driver.encoders.steer_ticks_per_turn, 4096U);
  EXPECT_EQ(params.session.plan.turn, 2.0);
  EXPECT_EQ(unknown, std::vector<std::string>{"/calibration/noise/slipp"});
}

TEST(CalibrationNodeParams, BeginWithAnEarlierCalibration) {
  const test::TemporaryFolder folder;
  StoredCalibration earlier;
  earlier.calibration = {{1.4, 3e-4, 0.01, 0.02}, 1.0, {0.3, 0.1, 0.05}};
  earlier.covariance.diagonal().setConstant(1e-8);
  const CalibrationVector values = vector_of(earlier.calibration);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const double value = values(static_cast<Eigen::Index>(i));
    earlier.intervals[i] = {value - 1e-6, value + 1e-6};
  }
  write_calibration(folder.path() + "/earlier.yaml", earlier);
  XmlRpc::XmlRpcValue tree;
  tree["folder"] = folder.path();
  tree["vehicle"]["calibration_file"] = "earlier.yaml";
  tree["vehicle"]["wheelbase"] = 1.5;  // counts less
  const CalibrationSessionParams session = read_calibration(tree).session;

  EXPECT_EQ(vector_of(believed_calibration(session)), values);
  EXPECT_EQ(session.calibrator.wheelbase, 1.4);
}

TEST(CalibrationNodeParams, AreRefusedByName) {
  XmlRpc::XmlRpcValue tree;
  tree["control_period"] = 0.0;
  test::expect_refused([&] { read_calibration(tree); }, {"/calibration", "control_period"});
  tree = XmlRpc::XmlRpcValue();
  tree["model"] = "differential";
  test::expect_refused([&] { read_calibration(tree); }, {"/calibration", "model"});
  tree = XmlRpc::XmlRpcValue();
  tree["vehicle"]["steer_ticks_per_turn"] = -3;
  test::expect_refused([&] { read_calibration(tree); }, {"/calibration", "steer_ticks_per_turn"});
  tree = XmlRpc::XmlRpcValue();
  tree["vehicle"]["wheelbase"] = 0.0;
  test::expect_refused([&] { read_calibration(tree); }, {"/calibration", "wheelbase"});
  tree = XmlRpc::XmlRpcValue();
  tree["arcs"]["max_steering"] = 0.2;
  test::expect_refused([&] { read_calibration(tree); }, {"/calibration", "max_steering"});
  tree = XmlRpc::XmlRpcValue();
  tree["vehicle"]["calibration_file"] = "/missing/calibration.yaml";
  test::expect_refused([&] { read_calibration(tree); },
                       {"/calibration", "/missing/calibration.yaml"});
  tree = XmlRpc::XmlRpcValue();
  tree["odom_frame"] = "";
  test::expect_refused([&] { read_calibration(tree); }, {"/calibration", "odom_frame"});
}

}  // namespace
}  // namespace falko_slam
