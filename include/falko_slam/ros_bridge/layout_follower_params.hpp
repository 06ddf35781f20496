// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "falko_slam/ros_bridge/vehicle_params.hpp"
#include "falko_slam/simulation/layout_follower.hpp"

namespace falko_slam {

/// Parameters of the LayoutFollower node, config/layout_follower.yaml.
struct LayoutFollowerNodeParams {
  std::string layout_file;    ///< read by read_layout()
  bool repeat = true;         ///< begin again at the end
  bool start_paused = false;  ///< until the service says otherwise
  double pose_timeout = 0.3;  ///< without a pose for so long it halts [s]
  LayoutFollowerParams follower;
  VehicleParams vehicle;
  EncoderParams encoders;  ///< as the vehicle's calibration has them
  Layout layout;           ///< that of the file
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LayoutFollowerNodeParams& params);

template <class Params, class Visitor>
void visit_layout_follower_fields(Params& params, Visitor& visitor) {
  visitor.field("layout_file", params.layout_file);
  visitor.field("repeat", params.repeat);
  visitor.field("start_paused", params.start_paused);
  visitor.field("pose_timeout", params.pose_timeout);
  visitor.begin("follower");
  visitor.field("acceleration", params.follower.acceleration);
  visitor.field("max_steering", params.follower.max_steering);
  visitor.field("response", params.follower.response);
  visitor.field("response_time", params.follower.response_time);
  visitor.field("max_sideways", params.follower.max_sideways);
  visitor.end();
  visitor.begin("vehicle");
  visit_vehicle_fields(params.vehicle, visitor);
  visitor.end();
}

/// `name` stands before the names in messages; `unknown` gets the names that no field has. Throws
/// std::invalid_argument with the parameter's full name, or that of a file.
LayoutFollowerNodeParams read_layout_follower_params(const XmlRpc::XmlRpcValue& tree,
                                                     const std::string& name,
                                                     std::vector<std::string>& unknown);

}  // namespace falko_slam
