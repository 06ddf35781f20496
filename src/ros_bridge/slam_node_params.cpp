// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/slam_node_params.hpp"

#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/slam/slam_fields.hpp"

namespace falko_slam {
namespace {

// Runs what may complain of a value, with the place of the parameters before its words.
template <class Work>
void naming(const std::string& name, Work&& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
}

void validate_frames(const SlamNodeParams& params) {
  if (params.map_frame.empty()) throw std::invalid_argument("map_frame is empty");
  if (params.use_odometry && params.map_frame == params.odom_frame) {
    throw std::invalid_argument("map_frame and odom_frame are both " + params.map_frame);
  }
  if (!params.use_odometry && params.base_frame.empty()) {
    throw std::invalid_argument(
        "base_frame is empty, and without odometry it is what tf to the map is of");
  }
}

}  // namespace

void validate(const SlamNodeParams& params) {
  validate_frames(params);
  require_in_range("transform_period", params.transform_period, 0.001, 10.0);
  require_in_range("transform_tolerance", params.transform_tolerance, 0.0, 10.0);
  require_in_range("scan_timeout", params.scan_timeout, 0.01, 1e6);
  require_in_range("max_correction_speed", params.slew.max_speed, 0.0, 1e6);
  require_in_range("max_correction_turn", params.slew.max_turn_speed, 0.0, 1e6);
  require_in_range("queue_size", params.queue_size, 10, 100000);
  require_in_range("map_update_period", params.map_update_period, 0.1, 1e6);
  validate(params.slam);
}

SlamNodeParams read_slam_node_params(const XmlRpc::XmlRpcValue& tree, const std::string& name,
                                     std::vector<std::string>& unknown) {
  SlamNodeParams params;
  ParameterReader reader(tree, name);
  visit_slam_node_fields(params, reader);
  visit_slam_fields(params.slam, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  for (std::string* frame : {&params.map_frame, &params.odom_frame, &params.base_frame}) {
    *frame = tf_frame(*frame);
  }
  params.use_odometry = params.use_odometry && !params.odom_frame.empty();
  params.map_folder =
      params.map_folder.empty() ? default_file_folder() : with_home(params.map_folder);
  params.state = path_in(params.map_folder, params.state);
  naming(name, [&] { validate(params); });
  return params;
}

SlamParams read_slam_params(const XmlRpc::XmlRpcValue& tree, const std::string& name,
                            std::vector<std::string>& unknown) {
  SlamNodeParams params;
  ParameterReader reader(tree, name);
  visit_slam_node_fields(params, reader);
  visit_slam_fields(params.slam, reader);
  unknown = reader.unknown();
  naming(name, [&] { validate(params.slam); });
  return params.slam;
}

}  // namespace falko_slam
