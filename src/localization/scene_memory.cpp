// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scene_memory.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kPoints = 360;        // of a scan, at most
constexpr std::size_t kLeastCompared = 30;  // fewer tell nothing
constexpr Duration kOldest = std::chrono::seconds(2);
constexpr double kSame = 0.25, kSameShare = 0.03;  // of a range and of its own [m], [1]

}  // namespace

std::optional<double> SceneMemory::share_seen_again(const LaserScan& scan, Time instant,
                                                    const OdometryTrack& track) {
  const Pose2 odom_T_laser = track.at(instant) * base_T_laser_;
  std::optional<double> result;
  if (!points_.empty() && instant > stamp_ && instant - stamp_ <= kOldest) {
    std::size_t compared = 0;
    const double share = share_in(scan, odom_T_laser.inverse(), compared);
    if (compared >= kLeastCompared) result = share;
  }
  if (instant > stamp_ || points_.empty()) {
    remember(scan, odom_T_laser);
    stamp_ = instant;
  }
  return result;
}

// A point is there still if one of the beams beside it ends near it; those whose beams have no
// range are not compared.
double SceneMemory::share_in(const LaserScan& scan, const Pose2& laser_T_odom,
                             std::size_t& compared) const {
  if (scan.size() < 2 || !(scan.angle_increment > 0.0)) return 1.0;
  const auto beams = static_cast<std::ptrdiff_t>(scan.size());
  std::size_t again = 0;
  for (const Eigen::Vector2d& point : points_) {
    const Eigen::Vector2d in_laser = laser_T_odom * point;
    const double bearing = std::atan2(in_laser.y(), in_laser.x());
    const double turn = wrap_angle(bearing - scan.angle_min - kPi) + kPi;
    const auto middle = static_cast<std::ptrdiff_t>(std::lround(turn / scan.angle_increment));
    if (!scan.closed && (middle < 1 || middle + 1 >= beams)) continue;
    const double range = in_laser.norm();
    bool valid = false, same = false;
    for (std::ptrdiff_t i = middle - 1; i <= middle + 1; ++i) {
      const auto beam = static_cast<std::size_t>(((i % beams) + beams) % beams);
      if (!scan.valid(beam)) continue;
      valid = true;
      same = same || std::abs(scan.ranges[beam] - range) < kSame + kSameShare * range;
    }
    if (valid) ++compared;
    if (same) ++again;
  }
  return compared == 0 ? 1.0 : static_cast<double>(again) / static_cast<double>(compared);
}

void SceneMemory::remember(const LaserScan& scan, const Pose2& odom_T_laser) {
  points_.clear();
  const std::size_t step = std::max<std::size_t>(1, scan.size() / kPoints);
  for (std::size_t beam = 0; beam < scan.size(); beam += step) {
    if (scan.valid(beam)) points_.push_back(odom_T_laser * scan.point(beam));
  }
}

}  // namespace falko_slam
