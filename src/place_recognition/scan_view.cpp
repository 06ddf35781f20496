// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_view.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Length of a piece of wall that a beam without neighbours stands for [m].
constexpr double kLoneLength = 0.02;
// Of so short a chord the noise is as great as the length [m].
constexpr double kShortChord = 0.04;

}  // namespace

void validate(const ScanViewParams& params) {
  require_in_range("point_spacing", params.point_spacing, 0.0, 10.0);
  require_in_range("max_range", params.max_range, 0.1, 1e5);
  require_in_range("normal_reach", params.normal_reach, 0.0, 10.0);
  validate(params.surface);
}

ScanView::ScanView(const LaserScan& scan, const ScanViewParams& params)
    : angle_min_(scan.angle_min),
      angle_increment_(scan.angle_increment),
      closed_(scan.closed),
      ranges_(scan.size(), 0.0),
      all_(scan.size()) {
  if (angle_increment_ > 0.0) {
    beams_per_radian_ = 1.0 / angle_increment_;
    beams_per_turn_ = kTwoPi * beams_per_radian_;
    turns_per_beam_ = angle_increment_ / kTwoPi;
  }
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!scan.valid(i)) continue;
    ranges_[i] = scan.ranges[i];
    if (scan.ranges[i] > params.max_range) continue;
    all_[i].position = scan.point(i);
    all_[i].length = kLoneLength;
  }
  for (std::size_t i = 0; i < all_.size(); ++i) measure_wall(i, params);
  keep_points(params.point_spacing);
}

// The beam that follows `beam` in a direction (1 or -1) on the same surface; itself if none does.
std::size_t ScanView::beside(std::size_t beam, int direction, const ScanViewParams& params) const {
  const std::size_t last = all_.size() - 1;
  const std::size_t end = direction > 0 ? last : 0;
  if (beam == end && !closed_) return beam;
  const std::size_t other = beam == end ? last - end : direction > 0 ? beam + 1 : beam - 1;
  if (all_[other].length <= 0.0) return beam;
  const bool joined =
      on_one_surface((all_[beam].position - all_[other].position).norm(),
                     std::min(ranges_[beam], ranges_[other]), angle_increment_, params.surface);
  return joined ? other : beam;
}

// Normal and length of the wall about a beam, from the beams beside it on the same surface. The
// normal looks `normal_reach` far: next beams may be nearer than their noise.
void ScanView::measure_wall(std::size_t beam, const ScanViewParams& params) {
  SurfacePoint& here = all_[beam];
  if (here.length <= 0.0) return;
  const Eigen::Vector2d next = all_[beside(beam, 1, params)].position;
  const Eigen::Vector2d previous = all_[beside(beam, -1, params)].position;
  const double length = 0.5 * (next - previous).norm();
  if (length > 0.0) here.length = length;
  if (!params.normals) return;
  const auto at_reach = [&](int direction) {
    std::size_t at = beam;
    for (std::size_t steps = 0; 2 * steps < all_.size(); ++steps) {
      const std::size_t joined = beside(at, direction, params);
      if (joined == at) break;
      at = joined;
      if ((all_[at].position - here.position).norm() >= params.normal_reach) break;
    }
    return all_[at].position;
  };
  const Eigen::Vector2d along = at_reach(1) - at_reach(-1);
  if (along.isZero(0.0)) return;
  const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
  // Both ends are off by as much; no normal is off by more than all directions are.
  here.normal_gain = 2.0 / (along.squaredNorm() + kShortChord * kShortChord);
  here.normal = normal.dot(here.position) > 0.0 ? Eigen::Vector2d(-normal) : normal;
}

// A point is the mean of the beams within `spacing` of the first of them: to pick one of them by
// its distance would prefer those whose noise points along the way.
void ScanView::keep_points(double spacing) {
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  double count = 0.0;
  const auto finish = [&] {
    if (count == 0.0) return;
    points_.back().position /= count;
    points_.back().normal = points_.back().normal.stableNormalized();
  };
  for (const SurfacePoint& here : all_) {
    if (here.length <= 0.0) continue;
    if (count > 0.0 && (here.position - first).norm() < spacing) {
      points_.back().position += here.position;
      points_.back().normal += here.normal;
      points_.back().length += here.length;
      ++count;
      continue;
    }
    finish();
    points_.push_back(here);
    first = here.position;
    count = 1.0;
  }
  finish();
}

}  // namespace falko_slam
