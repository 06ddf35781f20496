// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/keypoint_noise.hpp"

#include <algorithm>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

// To the farther one of the neighbours on its surface; across the sight where there is none.
Eigen::Vector2d way_to_next_beam(const LaserScan& scan, std::size_t beam,
                                 const Eigen::Vector2d& across, double range,
                                 const SurfaceStepParams& surface) {
  Eigen::Vector2d way = across * range * scan.angle_increment;
  double farthest = 0.0;
  for (const std::size_t step : {std::size_t{1}, scan.size() - 1}) {
    const bool inside = step == 1 ? beam + 1 < scan.size() : beam > 0;
    const std::size_t next = (beam + step) % scan.size();
    if (!(inside || scan.closed) || !scan.valid(beam) || !scan.valid(next)) continue;
    const Eigen::Vector2d there = scan.point(next) - scan.point(beam);
    const double nearer = std::min(scan.ranges[beam], scan.ranges[next]);
    if (there.norm() <= farthest ||
        !on_one_surface(there.norm(), nearer, scan.angle_increment, surface)) {
      continue;
    }
    farthest = there.norm();
    way = there;
  }
  return way;
}

}  // namespace

void validate(const KeypointNoise& noise) {
  require_in_range("range_noise", noise.range_noise, 1e-4, 1.0);
  require_in_range("bearing_noise", noise.bearing_noise, 0.0, 0.1);
  require_in_range("place_noise", noise.place_noise, 0.0, 1.0);
}

Eigen::Matrix2d keypoint_covariance(const LaserScan& scan, const Keypoint& keypoint,
                                    const KeypointNoise& noise, const SurfaceStepParams& surface) {
  const double range = keypoint.position.norm();
  const Eigen::Vector2d sight = keypoint.position.stableNormalized();
  const Eigen::Vector2d across(-sight.y(), sight.x());
  const Eigen::Vector2d way = way_to_next_beam(scan, keypoint.beam, across, range, surface);
  const double turned = noise.bearing_noise * range;
  return noise.range_noise * noise.range_noise * sight * sight.transpose() +
         turned * turned * across * across.transpose() + way * way.transpose() / 12.0 +
         noise.place_noise * noise.place_noise * Eigen::Matrix2d::Identity();
}

}  // namespace falko_slam
