// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/file_folder.hpp"

#include <cstdlib>

namespace falko_slam {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

std::string with_home(const std::string& path) {
  return path.compare(0, 2, "~/") == 0 ? environment("HOME") + path.substr(1) : path;
}

std::string default_file_folder() {
  const std::string home = environment("ROS_HOME");
  return (home.empty() ? environment("HOME") + "/.ros" : home) + "/falko_slam";
}

std::string path_in(const std::string& folder, const std::string& path) {
  const std::string whole = with_home(path);
  return whole.empty() || whole.front() == '/' ? whole : folder + "/" + whole;
}

}  // namespace falko_slam
