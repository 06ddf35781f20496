// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_range.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/calibration/path_segment.hpp"

namespace falko_slam {
namespace {

Eigen::Vector2d farther(const Eigen::Vector2d& point, double offset) {
  const double range = point.norm();
  return range > 0.0 ? Eigen::Vector2d(point * (1.0 + offset / range)) : point;
}

std::vector<PointPair> farther(std::vector<PointPair> pairs, double offset) {
  for (PointPair& pair : pairs) {
    pair.point_in_target = farther(pair.point_in_target, offset);
    pair.point_in_source = farther(pair.point_in_source, offset);
  }
  return pairs;
}

// Of all pairs, each motion being as good as it can be with this offset.
double chi2_of(const std::vector<ReflectorMotion>& motions, double offset) {
  double chi2 = 0.0;
  for (const ReflectorMotion& motion : motions) {
    const std::vector<PointPair> pairs = farther(motion.pairs, offset);
    const auto alignment = align(pairs, 1.0);
    if (!alignment) continue;
    for (const PointPair& pair : pairs) {
      const Eigen::Vector2d residual =
          alignment->target_T_source.pose * pair.point_in_source - pair.point_in_target;
      chi2 += pair.weight * residual.squaredNorm();
    }
  }
  return chi2;
}

double freedom_of(const std::vector<ReflectorMotion>& motions) {
  double freedom = 0.0;
  for (const ReflectorMotion& motion : motions) {
    freedom += 2.0 * static_cast<double>(motion.pairs.size()) - 3.0;
  }
  return freedom;
}

}  // namespace

RangeOffset estimate_range_offset(const std::vector<ReflectorMotion>& motions, double prior) {
  // Residuals are linear in so small an offset: three values give the parabola, twice its minimum.
  constexpr double kStep = 0.002;  // [m]
  constexpr int kRounds = 2;
  RangeOffset found{0.0, prior};
  if (motions.empty()) return found;
  double information = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const double less = chi2_of(motions, found.offset - kStep);
    const double here = chi2_of(motions, found.offset);
    const double more = chi2_of(motions, found.offset + kStep);
    const double spread = std::max(1.0, here / std::max(1.0, freedom_of(motions)));
    const double curvature = (more - 2.0 * here + less) / (kStep * kStep) / spread;
    const double slope = (more - less) / (2.0 * kStep) / spread;
    information = 0.5 * curvature + 1.0 / (prior * prior);
    found.offset -= (0.5 * slope + found.offset / (prior * prior)) / information;
  }
  found.deviation = 1.0 / std::sqrt(information);
  return found;
}

ReflectorMotion with_range_offset(const ReflectorMotion& motion, double offset) {
  auto mended = motion_of(farther(motion.pairs, offset));
  if (!mended) return motion;
  mended->turn = unwrapped_turn(mended->start_T_end.pose.theta(), motion.turn);
  mended->scans = motion.scans;
  return *mended;
}

}  // namespace falko_slam
