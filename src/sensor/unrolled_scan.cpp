// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/unrolled_scan.hpp"

#include <algorithm>

namespace falko_slam {

UnrolledScan::UnrolledScan(const LaserScan& scan, double max_range,
                           const SurfaceStepParams& surface)
    : points_(scan.size(), Eigen::Vector2d::Zero()), ranges_(scan.size()), joined_(scan.size()) {
  const auto is_usable = [&](std::size_t beam) {
    return scan.valid(beam) && scan.ranges[beam] <= max_range;
  };
  const auto joins = [&](std::size_t beam, std::size_t next) {
    if (!is_usable(beam) || !is_usable(next)) return false;
    return on_one_surface((scan.point(beam) - scan.point(next)).norm(),
                          std::min(scan.ranges[beam], scan.ranges[next]), scan.angle_increment,
                          surface);
  };
  if (scan.closed && size() > 0) {
    while (start_ < size() && joins((start_ + size() - 1) % size(), start_)) ++start_;
    start_ %= size();
  }
  for (std::size_t k = 0; k < size(); ++k) {
    const std::size_t beam = beam_of(k);
    if (!is_usable(beam)) continue;
    points_[k] = scan.point(beam);
    ranges_[k] = scan.ranges[beam];
    joined_[k] = k > 0 && joins(beam_of(k - 1), beam);
  }
}

}  // namespace falko_slam
