// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "falko_slam/place_recognition/keyframe_memory.hpp"

namespace falko_slam {

/// The parameters of the LoopClosure nodelet.
struct LoopClosureNodeParams {
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  std::string folder;    ///< of the files of keyframes; never empty after reading
  std::string database;  ///< whole path; empty: none
  LoopClosureParams closure;
};

/// Throws std::invalid_argument with the parameter's name and value. Fills `unknown` with the names
/// that nobody reads.
LoopClosureNodeParams read_loop_closure_parameters(const ros::NodeHandle& node,
                                                   std::vector<std::string>& unknown);

}  // namespace falko_slam
