// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tentative_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kLineTurn = 0.09;  // [rad]: faces that differ by more are not the same

}  // namespace

bool TentativeList::is_same(const Tentative& tentative, const SeenFeature& seen,
                            double angle) const {
  if (tentative.seen.is_line != seen.is_line) return false;
  const Eigen::Vector2d way = seen.in_map - tentative.seen.in_map;
  if (!seen.is_line) return way.norm() < reach_;
  const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
  return std::abs(angle_between(tentative.angle, angle)) < kLineTurn &&
         std::abs(normal.dot(way)) < reach_ &&
         overlap(angle, tentative.seen.in_map, 0.5 * tentative.seen.line.half_length, seen.in_map,
                 0.5 * seen.line.half_length);
}

bool TentativeList::note(const SeenFeature& seen, double angle, Time stamp) {
  auto nearest = features_.end();
  double least = std::numeric_limits<double>::infinity();
  for (auto it = features_.begin(); it != features_.end(); ++it) {
    const double distance = (seen.in_map - it->seen.in_map).norm();
    if (it->last_seen == stamp || distance >= least || !is_same(*it, seen, angle)) continue;
    nearest = it;
    least = distance;
  }
  const int hits = nearest == features_.end() ? 1 : nearest->hits + 1;
  if (hits >= hits_) {
    if (nearest != features_.end()) features_.erase(nearest);
    return true;
  }
  if (nearest == features_.end()) {
    features_.push_back({seen, angle, 1, stamp});
  } else {
    *nearest = {seen, angle, hits, stamp};
  }
  return false;
}

void TentativeList::forget(Time stamp, Duration after) {
  const auto old = [&](const Tentative& tentative) { return stamp - tentative.last_seen > after; };
  features_.erase(std::remove_if(features_.begin(), features_.end(), old), features_.end());
}

}  // namespace falko_slam
