// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/pose_bytes.hpp"

#include <cmath>
#include <string>

#include "falko_slam/common/sealed_bytes.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void put(ByteWriter& out, const Pose2& pose) {
  out.f64(pose.x());
  out.f64(pose.y());
  out.f64(pose.theta());
}

Pose2 take_pose(ByteReader& in) {
  constexpr double kFarthest = 1e9;  // [m]
  const double x = in.f64(), y = in.f64(), theta = in.f64();
  require_sound(std::abs(x) <= kFarthest && std::abs(y) <= kFarthest && std::abs(theta) <= kTwoPi,
                "a pose of " + std::to_string(x) + ", " + std::to_string(y) + ", " +
                    std::to_string(theta) + " makes no sense");
  return {x, y, theta};
}

}  // namespace falko_slam
