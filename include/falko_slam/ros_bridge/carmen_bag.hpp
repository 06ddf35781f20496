// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

struct CarmenBagParams {
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  std::string laser_frame = "laser";
  std::string map_frame = "map";
  bool replace = false;  ///< an existing file
};

/// Converts a CARMEN log to a ROS bag and returns what was read and written, in words.
///
/// Topics: `scan`, `odom` (pose of base_frame in odom_frame with every scan and every ODOM line),
/// `tf` (the same, odom_frame -> base_frame), `tf_static` (base_frame -> laser_frame, from the
/// first scan) and, of corrected logs, `ground_truth` (pose of base_frame in map_frame). Messages
/// keep the order of the log and their own stamps, also where these run backward; the times at
/// which the bag plays them never do. Throws std::runtime_error that names the file.
std::string convert_carmen_log(const std::string& log, const std::string& bag,
                               const CarmenBagParams& params);

}  // namespace falko_slam
