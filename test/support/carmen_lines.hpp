// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {
namespace test {

// Lines of CARMEN logs.

inline std::string text_of(const Pose2& pose) {
  std::ostringstream text;
  text << std::setprecision(12) << pose.x() << " " << pose.y() << " " << pose.theta();
  return text.str();
}

inline std::string text_of(double seconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << seconds;
  return text.str();
}

/// Beams over 180 degrees from -90.
inline std::string flaser_line(const std::vector<float>& ranges, const Pose2& world_T_laser,
                               const Pose2& odom_T_robot, double stamp) {
  std::ostringstream line;
  line << "FLASER " << ranges.size();
  for (const float range : ranges) line << " " << range;
  line << " " << text_of(world_T_laser) << " " << text_of(odom_T_robot) << " " << text_of(stamp)
       << " host 0\n";
  return line.str();
}

/// Beams of 0.1 rad from -1, up to 50 m.
inline std::string robotlaser_line(const std::vector<float>& ranges, const Pose2& world_T_laser,
                                   const Pose2& world_T_robot, double stamp) {
  std::ostringstream line;
  line << "ROBOTLASER1 0 -1 2 0.1 50 0.01 0 " << ranges.size();
  for (const float range : ranges) line << " " << range;
  line << " 0 " << text_of(world_T_laser) << " " << text_of(world_T_robot) << " 0 0 0 0 0 "
       << text_of(stamp) << " host 0\n";
  return line.str();
}

inline std::string vertex_line(std::size_t index, const Pose2& map_T_robot) {
  return "VERTEX2 " + std::to_string(index) + " " + text_of(map_T_robot) + "\n";
}

inline std::string odom_line(const Pose2& odom_T_robot, double stamp) {
  return "ODOM " + text_of(odom_T_robot) + " 0.5 0.25 0 " + text_of(stamp) + " host 0\n";
}

}  // namespace test
}  // namespace falko_slam
