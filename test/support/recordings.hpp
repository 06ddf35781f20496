// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace falko_slam {
namespace test {

/// Where raw CARMEN logs and their relations are, if there are any.
inline std::string carmen_folder() {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  return std::string(folder ? folder : FALKO_SLAM_SOURCE_DIR "/../shared/data") + "/carmen/";
}

}  // namespace test
}  // namespace falko_slam
