// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

struct TransformSlewParams {
  /// How fast the vehicle's pose in the map may be moved and turned by corrections. 0: at once.
  /// [0, 1e6] [m/s], [rad/s]
  double max_speed = 0.0;
  double max_turn_speed = 0.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const TransformSlewParams& params);

/// Lets map_T_odom follow the map's corrections slowly, for controllers that cannot take jumps.
///
/// The speeds are those of the vehicle, not of the odometry's origin, which may be far off: a small
/// turn there is a long way here.
class TransformSlew {
 public:
  explicit TransformSlew(const TransformSlewParams& params = {});

  /// What is to be reached, and where the vehicle is now. The first one is taken at once.
  void aim(const Pose2& map_T_odom, const Pose2& odom_T_base);
  /// The next one is taken at once again.
  void reset() { target_.reset(); }
  /// map_T_odom after so many more seconds. Empty if there is nothing to be reached.
  std::optional<Pose2> advance(double seconds);

 private:
  TransformSlewParams params_;
  std::optional<Pose2> target_;
  Pose2 now_;  // map_T_odom
  Pose2 odom_T_base_;
};

}  // namespace falko_slam
