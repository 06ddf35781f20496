// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_view.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Length of a piece of wall that a beam without neighbours stands for [m].
constexpr double kLoneLength = 0.02;

}  // namespace

ScanView::ScanView(const LaserScan& scan, const ScanViewParams& params)
    : angle_min_(scan.angle_min),
      angle_increment_(scan.angle_increment),
      closed_(scan.closed),
      ranges_(scan.size(), 0.0),
      all_(scan.size()) {
  const std::size_t beams = scan.size();
  for (std::size_t i = 0; i < beams; ++i) {
    if (!scan.valid(i)) continue;
    ranges_[i] = scan.ranges[i];
    if (scan.ranges[i] > params.max_range) continue;
    all_[i].position = scan.point(i);
    all_[i].length = kLoneLength;
  }
  // The beams beside beam i on the same surface; i itself where there is none.
  const auto joined = [&](std::size_t i, std::size_t j) {
    if (all_[i].length <= 0.0 || all_[j].length <= 0.0) return false;
    const double across = std::min(ranges_[i], ranges_[j]) * angle_increment_;
    const double step = (all_[i].position - all_[j].position).norm();
    return step < std::max(params.max_step, params.step_ratio * across);
  };
  for (std::size_t i = 0; i < beams; ++i) {
    if (all_[i].length <= 0.0) continue;
    std::size_t left = i;
    std::size_t right = i;
    if (i > 0 || closed_) {
      const std::size_t before = i > 0 ? i - 1 : beams - 1;
      if (joined(i, before)) left = before;
    }
    if (i + 1 < beams || closed_) {
      const std::size_t after = i + 1 < beams ? i + 1 : 0;
      if (joined(i, after)) right = after;
    }
    if (left == right) continue;
    const Eigen::Vector2d along = all_[right].position - all_[left].position;
    const double length = along.norm();
    if (length <= 0.0) continue;
    Eigen::Vector2d normal(-along.y() / length, along.x() / length);
    if (normal.dot(all_[i].position) > 0.0) normal = -normal;
    all_[i].normal = normal;
    all_[i].length = std::max(kLoneLength, 0.5 * length);
  }
  const SurfacePoint* last = nullptr;
  for (std::size_t i = 0; i < beams; ++i) {
    const SurfacePoint& here = all_[i];
    if (here.length <= 0.0) continue;
    if (last != nullptr) {
      const double step = (here.position - last->position).norm();
      if (step < params.point_spacing) {
        points_.back().length += here.length;
        continue;
      }
    }
    points_.push_back(here);
    last = &here;
  }
}

ScanView::Beams ScanView::beams_at(double bearing) const {
  if (all_.empty() || angle_increment_ <= 0.0) return {};
  double turn = (bearing - angle_min_) / angle_increment_;
  const double full = kTwoPi / angle_increment_;
  turn -= full * std::floor((turn + 0.5) / full);
  const auto nearest = static_cast<std::size_t>(turn + 0.5);
  if (nearest < all_.size()) return {nearest, true};
  return closed_ ? Beams{0, true} : Beams{};
}

}  // namespace falko_slam
