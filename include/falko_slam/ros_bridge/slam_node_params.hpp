// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "falko_slam/slam/slam_params.hpp"
#include "falko_slam/slam/transform_slew.hpp"

namespace falko_slam {

/// The parameters of the PoseGraph nodelet; what they mean stands in config/slam.yaml.
struct SlamNodeParams {
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  bool use_odometry = true;
  bool publish_tf = true;
  double transform_period = 0.05;    ///< [0.001, 10] [s]
  double transform_tolerance = 0.1;  ///< [0, 10] [s]
  double scan_timeout = 3.0;         ///< [0.01, 1e6] [s]
  TransformSlewParams slew;
  int queue_size = 200;            ///< [10, 100000]
  double map_update_period = 5.0;  ///< [0.1, 1e6] [s]
  std::string map_folder;
  std::string state;
  SlamParams slam;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SlamNodeParams& params);

/// The names of all but `slam`, for a visitor that takes texts, too (ParameterReader).
template <class Params, class Visitor>
void visit_slam_node_fields(Params& params, Visitor& visitor) {
  visitor.field("map_frame", params.map_frame);
  visitor.field("odom_frame", params.odom_frame);
  visitor.field("base_frame", params.base_frame);
  visitor.field("use_odometry", params.use_odometry);
  visitor.field("publish_tf", params.publish_tf);
  visitor.field("transform_period", params.transform_period);
  visitor.field("transform_tolerance", params.transform_tolerance);
  visitor.field("scan_timeout", params.scan_timeout);
  visitor.field("max_correction_speed", params.slew.max_speed);
  visitor.field("max_correction_turn", params.slew.max_turn_speed);
  visitor.field("queue_size", params.queue_size);
  visitor.field("map_update_period", params.map_update_period);
  visitor.field("map_folder", params.map_folder);
  visitor.field("state", params.state);
}

/// From a tree of parameters, `name` before them in messages. Frames come without leading slash,
/// `use_odometry` is off without an odometry's frame, `map_folder` is never empty and `state` empty
/// or a whole path. Throws std::invalid_argument with the parameter's name and value; `unknown` is
/// filled with the names that nobody reads.
SlamNodeParams read_slam_node_params(const XmlRpc::XmlRpcValue& tree, const std::string& name,
                                     std::vector<std::string>& unknown);

/// The same of `slam` alone, for who has no node. Names of the node are read by nobody, but known.
SlamParams read_slam_params(const XmlRpc::XmlRpcValue& tree, const std::string& name,
                            std::vector<std::string>& unknown);

}  // namespace falko_slam
