// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "kept_sight.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

KeptSight::KeptSight(const Pose2& map_T_laser, const LaserScan& scan)
    : laser_T_map_(map_T_laser.inverse()),
      angle_min_(scan.angle_min),
      angle_increment_(scan.angle_increment),
      ranges_(scan.ranges.size()) {
  std::transform(scan.ranges.begin(), scan.ranges.end(), ranges_.begin(),
                 [](double range) { return static_cast<float>(range); });
}

PlaceSight KeptSight::at(const Eigen::Vector2d& point_in_map, double radius) const {
  const Eigen::Vector2d point = laser_T_map_ * point_in_map;
  const double distance = point.norm();
  if (distance <= radius || angle_increment_ <= 0.0) return PlaceSight::kUnknown;
  if (distance * angle_increment_ > radius) return PlaceSight::kUnknown;
  const double half_angle = std::asin(radius / distance);
  return of_beams(std::atan2(point.y(), point.x()), half_angle, distance - radius,
                  distance + radius);
}

PlaceSight KeptSight::of_beams(double bearing, double half_angle, double near, double far) const {
  const double from_first = wrap_angle(bearing - angle_min_);
  const auto first =
      static_cast<std::int64_t>(std::ceil((from_first - half_angle) / angle_increment_));
  const auto last =
      static_cast<std::int64_t>(std::floor((from_first + half_angle) / angle_increment_));
  const auto count = static_cast<std::int64_t>(ranges_.size());
  const auto turn = static_cast<std::int64_t>(std::lround(kTwoPi / angle_increment_));
  bool hidden = false;
  for (std::int64_t i = first; i <= last; ++i) {
    const std::int64_t beam = i < 0 ? i + turn : i;
    if (beam >= count) return PlaceSight::kUnknown;
    const double range = ranges_[static_cast<std::size_t>(beam)];
    if (range >= near && range <= far) return PlaceSight::kSurface;
    if (!(range > far)) hidden = true;
  }
  return hidden ? PlaceSight::kUnknown : PlaceSight::kSeenThrough;
}

}  // namespace falko_slam
