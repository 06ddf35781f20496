// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scan_sight.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

bool ScanSight::reaches(const Eigen::Vector2d& point_in_laser, double half_width,
                        double margin) const {
  const double range = point_in_laser.norm();
  const auto beams = static_cast<std::ptrdiff_t>(scan_.size());
  if (!(range > 0.0) || beams == 0 || !(scan_.angle_increment > 0.0)) return false;
  const double turn =
      wrap_angle(std::atan2(point_in_laser.y(), point_in_laser.x()) - scan_.angle_min - kPi) + kPi;
  const double half = std::min(half_width / range, kPi / 2.0);
  const double first = std::floor((turn - half) / scan_.angle_increment);
  const double last = std::ceil((turn + half) / scan_.angle_increment);
  std::size_t reaching = 0;
  for (auto i = static_cast<std::ptrdiff_t>(first); i <= static_cast<std::ptrdiff_t>(last); ++i) {
    if (!scan_.closed && (i < 0 || i >= beams)) return false;
    const auto beam = static_cast<std::size_t>(((i % beams) + beams) % beams);
    if (!scan_.valid(beam)) continue;
    if (scan_.ranges[beam] < range - margin) return false;
    ++reaching;
  }
  return reaching > 0;
}

}  // namespace falko_slam
