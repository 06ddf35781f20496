// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/common/keyframe_id.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/wall_end.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/matching/match_result.hpp"
#include "falko_slam/place_recognition/glare.hpp"
#include "falko_slam/place_recognition/scan_view.hpp"

namespace falko_slam {

/// A scan as the loop detector remembers it.
struct Keyframe {
  KeyframeId id;
  std::size_t drive = 0;           ///< poses and paths compare within one drive only
  Pose2 odom_T_laser;              ///< as it came
  Pose2 mended_T_laser;            ///< the same, mended by ScanOdometry: what neighbours lie by
  double path = 0.0;               ///< length of the way there since the drive's first keyframe [m]
  std::vector<MatchPoint> points;  ///< corners and wall ends, laser frame
  Signature signature;             ///< GLARE of the points beside GLARE of the walls
  ScanView view;
};

struct KeyframeParams {
  /// Looser than the detector's defaults: for matching many keypoints count more than good ones.
  FalkoParams falko = loose_falko_params();
  WallEndParams wall_end;
  GlareParams glare;
  ScanViewParams view;
  /// The walls are sampled at this distance for their signature, out to wall_range. [m]
  double wall_spacing = 0.30;
  double wall_range = 12.0;

  static FalkoParams loose_falko_params();
};
/// Throws std::invalid_argument with the field and its value.
void validate(const KeyframeParams& params);

/// Makes keyframes of scans. Not thread-safe: it keeps its detector's memory.
class KeyframeBuilder {
 public:
  explicit KeyframeBuilder(const KeyframeParams& params = {});

  /// Id, drive, pose and path are left to the caller.
  Keyframe build(const LaserScan& scan);

  const KeyframeParams& params() const { return params_; }

 private:
  KeyframeParams params_;
  FalkoDetector falko_;
};

/// Points of the walls that the scan saw, `spacing` apart along each of them and within
/// `max_range` of the laser [m].
std::vector<Eigen::Vector2d> sampled_walls(const ScanView& view, double spacing, double max_range);

}  // namespace falko_slam
