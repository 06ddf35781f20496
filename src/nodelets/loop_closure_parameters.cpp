// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_closure_parameters.hpp"

#include <stdexcept>

#include "falko_slam/place_recognition/loop_closure_fields.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {

LoopClosureNodeParams read_loop_closure_parameters(const ros::NodeHandle& node,
                                                   std::vector<std::string>& unknown) {
  LoopClosureNodeParams params;
  ParameterReader reader(parameter_tree(node), node.getNamespace());
  reader.field("odom_frame", params.odom_frame);
  reader.field("base_frame", params.base_frame);
  reader.field("folder", params.folder);
  reader.field("database", params.database);
  visit_loop_closure_fields(params.closure, reader);
  validate(params.closure);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});

  params.odom_frame = tf_frame(params.odom_frame);
  params.base_frame = tf_frame(params.base_frame);
  if (params.odom_frame.empty()) {
    throw std::invalid_argument(node.getNamespace() + "/odom_frame is empty");
  }
  params.folder = params.folder.empty() ? default_file_folder() : with_home(params.folder);
  params.database = path_in(params.folder, params.database);
  return params;
}

}  // namespace falko_slam
