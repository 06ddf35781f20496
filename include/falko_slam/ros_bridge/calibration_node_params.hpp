// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "falko_slam/calibration/calibration_session.hpp"
#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/ros_bridge/vehicle_params.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

const EnumNames<EgomotionSource>& egomotion_source_names();
const EnumNames<TricycleModel>& tricycle_model_names();
/// Throws std::invalid_argument that lists the names.
TricycleModel tricycle_model_of(const std::string& name);

/// Parameters of the Calibration node, config/calibration.yaml.
struct CalibrationNodeParams {
  CalibrationSessionParams session;
  ScanNormalizerParams scan;  ///< where egomotion is from scans
  VehicleParams vehicle;
  double control_period = 0.05;     ///< [s]
  double feedback_period = 0.5;     ///< [s]
  std::string odom_frame = "odom";  ///< markers are drawn there
  std::string base_frame = "base_link";
  std::string folder;                     ///< for files
  std::string file = "calibration.yaml";  ///< of the result; empty: none is written
  bool accept_weak = false;               ///< write what is WEAK, too
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationNodeParams& params);

/// `name` stands before the names in messages; `unknown` gets the names that no field has. Reads
/// the vehicle's calibration, too: the session begins with what it says. Throws
/// std::invalid_argument with the parameter's full name.
CalibrationNodeParams read_calibration_node_params(const XmlRpc::XmlRpcValue& tree,
                                                   const std::string& name,
                                                   std::vector<std::string>& unknown);

/// What a vehicle's controller believes.
VehicleCalibration believed_calibration(const CalibrationSessionParams& params);

/// The parameters that a calibration begins with.
void believe(const VehicleCalibration& calibration, CalibrationSessionParams& params);

}  // namespace falko_slam
