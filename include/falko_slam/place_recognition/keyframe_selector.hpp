// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

struct KeyframeSelectorParams {
  /// A scan becomes a keyframe if the laser has moved this far from the last one, or turned by this
  /// much. Smaller: more keyframes, and more time and memory for them. [0, 100] [m], [0, pi] [rad]
  double min_step = 0.20;
  double min_turn = 0.35;
  /// If it has moved farther from one scan to the next, then the odometry was reset: a new drive.
  /// [0.1, 1e6] [m]
  double max_jump = 5.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const KeyframeSelectorParams& params);

/// Chooses the scans of a drive that are worth to be remembered. Not thread-safe.
class KeyframeSelector {
 public:
  explicit KeyframeSelector(const KeyframeSelectorParams& params = {});

  enum class Choice {
    kPassOver,    ///< too near to the last keyframe
    kKeyframe,    ///< the first one, or far enough
    kFirstOfNew,  ///< a keyframe, and the odometry has jumped: it begins a drive
  };
  /// For each scan in turn. Poses that are not finite are passed over.
  Choice choose(const Pose2& odom_T_laser);
  /// The next scan becomes a keyframe.
  void reset();

  const KeyframeSelectorParams& params() const { return params_; }

 private:
  KeyframeSelectorParams params_;
  std::optional<Pose2> keyframe_;  // the last one
  std::optional<Pose2> last_;      // scan
};

}  // namespace falko_slam
