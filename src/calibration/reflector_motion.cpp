// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_motion.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

// Of a coordinate [m].
double rms_of(const std::vector<PointPair>& pairs, const Pose2& target_T_source) {
  double squares = 0.0;
  for (const PointPair& pair : pairs) {
    squares += (target_T_source * pair.point_in_source - pair.point_in_target).squaredNorm();
  }
  return std::sqrt(squares / (2.0 * static_cast<double>(pairs.size())));
}

double chi2_of(const PointPair& pair, const Pose2& target_T_source) {
  return pair.weight *
         (target_T_source * pair.point_in_source - pair.point_in_target).squaredNorm();
}

}  // namespace

void drop_outliers(std::vector<PointPair>& pairs, std::size_t least) {
  constexpr double kSignificant = 18.4;  // chi2 of two degrees of freedom, 99.99 %
  while (pairs.size() > least) {
    const auto alignment = align(pairs, 1.0);
    if (!alignment) return;
    const Pose2& pose = alignment->target_T_source.pose;
    const auto worst =
        std::max_element(pairs.begin(), pairs.end(), [&](const PointPair& a, const PointPair& b) {
          return chi2_of(a, pose) < chi2_of(b, pose);
        });
    if (chi2_of(*worst, pose) < kSignificant) return;
    pairs.erase(worst);
  }
}

std::optional<ReflectorMotion> motion_of(std::vector<PointPair> pairs) {
  const auto expected = align(pairs, 1.0);
  const auto measured = align(pairs);
  if (!expected || !measured) return std::nullopt;
  ReflectorMotion motion;
  motion.start_T_end = expected->target_T_source;
  const double freedom = 2.0 * static_cast<double>(pairs.size()) - 3.0;
  const double worse = measured->target_T_source.covariance.trace() /
                       std::max(1e-300, expected->target_T_source.covariance.trace());
  if (worse > 1.0 + 3.0 * std::sqrt(2.0 / freedom)) motion.start_T_end.covariance *= worse;
  motion.turn = motion.start_T_end.pose.theta();
  motion.rms_residual = rms_of(pairs, motion.start_T_end.pose);
  motion.pairs = std::move(pairs);
  return motion;
}

}  // namespace falko_slam
