// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The main function of each nodelet's node of its own. Which it is stands in its node_name.cpp.in.
#include "node_name.hpp"

#include <nodelet/loader.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, falko_slam::kNodeName);
  nodelet::Loader loader(false);
  const nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), falko_slam::kNodeletType, ros::names::getRemappings(),
                   arguments)) {
    return 1;
  }
  ros::spin();
  return 0;
}
