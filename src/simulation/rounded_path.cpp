// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rounded_path.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kSpacing = 0.02;  // [m]

}  // namespace

RoundedPath::RoundedPath(const std::vector<Eigen::Vector2d>& through, double corner_radius) {
  append(through.front());
  const std::size_t last = through.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    // A line between two corners is for both of them.
    const double before = (through[i] - through[i - 1]).norm() * (i == 1 ? 1.0 : 0.5);
    const double after = (through[i + 1] - through[i]).norm() * (i + 1 == last ? 1.0 : 0.5);
    append_corner(through[i - 1], through[i], through[i + 1], corner_radius,
                  std::min(before, after));
  }
  append(through.back());
}

// Straight on from the last point.
void RoundedPath::append(const Eigen::Vector2d& point) {
  if (points_.empty()) {
    points_.push_back(point);
    way_.push_back(0.0);
    return;
  }
  const Eigen::Vector2d from = points_.back();
  const double begin = way_.back();
  const double length = (point - from).norm();
  if (begin + length == begin) return;  // as near as numbers tell apart
  const int pieces = static_cast<int>(std::ceil(length / kSpacing));
  for (int i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    points_.emplace_back(from + share * (point - from));
    way_.push_back(begin + share * length);
  }
}

void RoundedPath::append_corner(const Eigen::Vector2d& before, const Eigen::Vector2d& corner,
                                const Eigen::Vector2d& after, double radius, double room) {
  const Eigen::Vector2d in = (corner - before).normalized();
  const Eigen::Vector2d out = (after - corner).normalized();
  const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
  const double half_tangent = std::tan(0.5 * std::abs(turn));
  const double cut = std::min(radius * half_tangent, room);
  const double used_radius = half_tangent > 1e-9 ? cut / half_tangent : 0.0;
  append(corner - cut * in);
  const Eigen::Vector2d begin = points_.back();
  const double heading = std::atan2(in.y(), in.x());
  const double side = std::copysign(1.0, turn);
  const int pieces = static_cast<int>(std::ceil(std::abs(turn) * used_radius / kSpacing));
  for (int i = 1; i <= pieces; ++i) {
    const double angle = heading + turn * i / pieces;
    append(begin + used_radius * side *
                       Eigen::Vector2d(std::sin(angle) - std::sin(heading),
                                       std::cos(heading) - std::cos(angle)));
  }
}

Eigen::Vector2d RoundedPath::mean_around(double way, double half) const {
  const int pieces = std::max(1, static_cast<int>(std::ceil(2.0 * half / kSpacing)));
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < pieces; ++i) sum += at(way - half + 2.0 * half * (i + 0.5) / pieces);
  return sum / pieces;
}

RoundedPath RoundedPath::smoothed(double window) const {
  RoundedPath smooth;
  const int pieces = std::max(1, static_cast<int>(std::ceil(length() / kSpacing)));
  for (int i = 0; i <= pieces; ++i) {
    const double way = length() * i / pieces;
    smooth.append(mean_around(way, std::min({0.5 * window, way, length() - way})));
  }
  return smooth;
}

Eigen::Vector2d RoundedPath::at(double way) const {
  const auto after = std::upper_bound(way_.begin(), way_.end(), way);
  auto i = static_cast<std::size_t>(after - way_.begin());
  i = std::clamp<std::size_t>(i, 1, std::max<std::size_t>(1, points_.size() - 1));
  if (points_.size() < 2) return points_.front();
  const double share = (way - way_[i - 1]) / (way_[i] - way_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

double RoundedPath::nearest(const Eigen::Vector2d& point, double from, double to) const {
  double best = from;
  double least = (at(from) - point).squaredNorm();
  auto i =
      static_cast<std::size_t>(std::lower_bound(way_.begin(), way_.end(), from) - way_.begin());
  for (; i < way_.size() && way_[i] <= to; ++i) {
    const double distance = (points_[i] - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = way_[i];
  }
  return best;
}

}  // namespace falko_slam
