// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe.hpp"

#include <utility>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

FalkoParams KeyframeParams::loose_falko_params() {
  FalkoParams params;
  params.neighborhood.radius_scale = 0.30;
  params.triangle_ratio = 8.0;
  params.suppression_radius = 0.15;
  params.merge_radius = 0.075;
  return params;
}

void validate(const KeyframeParams& params) {
  validate(params.falko);
  validate(params.wall_end);
  validate(params.glare);
  validate(params.view);
  require_in_range("wall_spacing", params.wall_spacing, 0.01, 100.0);
  require_in_range("wall_range", params.wall_range, 0.1, 1000.0);
}

KeyframeBuilder::KeyframeBuilder(const KeyframeParams& params)
    : params_((validate(params), params)), falko_(params.falko) {}

Keyframe KeyframeBuilder::build(const LaserScan& scan) {
  Keyframe keyframe;
  std::vector<Eigen::Vector2d> positions;
  for (const auto& keypoints : {falko_.detect(scan), find_wall_ends(scan, params_.wall_end)}) {
    for (const Keypoint& keypoint : keypoints) {
      keyframe.points.push_back({keypoint.position, keypoint.orientation});
      positions.push_back(keypoint.position);
    }
  }
  keyframe.view = ScanView(scan, params_.view);
  const auto walls = sampled_walls(keyframe.view, params_.wall_spacing, params_.wall_range);
  keyframe.signature = joined(glare(positions, params_.glare), glare(walls, params_.glare));
  return keyframe;
}

std::vector<Eigen::Vector2d> sampled_walls(const ScanView& view, double spacing, double max_range) {
  constexpr double kGap = 0.50;  // a longer step leads to another wall [m]
  std::vector<Eigen::Vector2d> samples;
  const SurfacePoint* last = nullptr;
  double way = 0.0;  // since the last sample
  for (const SurfacePoint& point : view.points()) {
    if (point.position.norm() > max_range) {
      last = nullptr;
      continue;
    }
    const double step = last != nullptr ? (point.position - last->position).norm() : kGap;
    way = step < kGap ? way + step : spacing;
    if (way >= spacing) {
      samples.push_back(point.position);
      way = 0.0;
    }
    last = &point;
  }
  return samples;
}

}  // namespace falko_slam
