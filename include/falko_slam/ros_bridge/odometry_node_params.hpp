// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "falko_slam/ros_bridge/vehicle_params.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

/// Parameters of the TricycleOdometry node, config/tricycle_odometry.yaml.
struct OdometryNodeParams {
  VehicleParams vehicle;
  VehicleCalibration calibration;  ///< what the vehicle's parameters and its file say
  EncoderParams encoders;          ///< the same, with the calibrated steer gain
  TricycleOdometryParams odometry;
  OdometryNoise noise;
  double encoder_timeout = 1.0;  ///< without encoders for so long diagnostics warn [s]
  bool publish_tf = true;        ///< odom to base_link
  bool publish_laser_tf = true;  ///< base_link to laser, static
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  std::string laser_frame = "laser";
};
/// Throws std::invalid_argument with the field and its value.
void validate(const OdometryNodeParams& params);

template <class Params, class Visitor>
void visit_odometry_node_fields(Params& params, Visitor& visitor) {
  visitor.field("odom_frame", params.odom_frame);
  visitor.field("base_frame", params.base_frame);
  visitor.field("laser_frame", params.laser_frame);
  visitor.field("publish_tf", params.publish_tf);
  visitor.field("publish_laser_tf", params.publish_laser_tf);
  visitor.field("max_wheel_speed", params.odometry.max_wheel_speed);
  visitor.field("encoder_timeout", params.encoder_timeout);
  visitor.begin("noise");
  visitor.field("slip", params.noise.slip);
  visitor.field("steer", params.noise.steer);
  visitor.end();
  visitor.begin("vehicle");
  visit_vehicle_fields(params.vehicle, visitor);
  visitor.end();
}

/// `name` stands before the names in messages; `unknown` gets the names that no field has. Throws
/// std::invalid_argument with the parameter's full name, or that of the calibration's file.
OdometryNodeParams read_odometry_node_params(const XmlRpc::XmlRpcValue& tree,
                                             const std::string& name,
                                             std::vector<std::string>& unknown);

}  // namespace falko_slam
