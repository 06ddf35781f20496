// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_overlap.hpp"

#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

bool sees_free(const LaserScan& scan, const Eigen::Vector2d& point_in_laser) {
  const double bearing = std::atan2(point_in_laser.y(), point_in_laser.x());
  double turn = wrap_angle(bearing - scan.angle_min);
  if (turn < -0.5 * scan.angle_increment) turn += kTwoPi;
  const double lag = std::round(turn / scan.angle_increment);
  if (!(lag >= 0.0)) return false;
  auto beam = static_cast<std::size_t>(lag);
  if (scan.closed && beam == scan.size()) beam = 0;
  if (beam >= scan.size() || !scan.valid(beam)) return false;
  return point_in_laser.squaredNorm() <= scan.ranges[beam] * scan.ranges[beam];
}

}  // namespace

double scan_overlap(const PosedScan& a, const PosedScan& b, double cell, double max_range) {
  const Pose2 b_T_a = b.map_T_laser.inverse() * a.map_T_laser;
  const auto steps = static_cast<int>(max_range / cell);
  int both = 0;
  int either = 0;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Eigen::Vector2d point_in_a(cell * i, cell * j);
      const bool in_a = sees_free(a.scan, point_in_a);
      const bool in_b = sees_free(b.scan, b_T_a * point_in_a);
      both += static_cast<int>(in_a && in_b);
      either += static_cast<int>(in_a || in_b);
    }
  }
  return either > 0 ? static_cast<double>(both) / either : 0.0;
}

}  // namespace falko_slam
