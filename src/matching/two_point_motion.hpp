// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

/// A rigid motion without its angle: no trigonometry to make one or apply it.
struct TwoPointMotion {
  double cosine, sine, x, y;

  Eigen::Vector2d operator*(const Eigen::Vector2d& p) const {
    return {cosine * p.x() - sine * p.y() + x, sine * p.x() + cosine * p.y() + y};
  }
  Pose2 pose() const { return {x, y, std::atan2(sine, cosine)}; }
};

/// The motion that takes the source points of two pairs nearest to their target points. Neither two
/// source points nor two target points may coincide.
inline TwoPointMotion motion_of(const MatchPair& a, const MatchPair& b,
                                const std::vector<MatchPoint>& source,
                                const std::vector<MatchPoint>& target) {
  const Eigen::Vector2d s = source[b.source].position - source[a.source].position;
  const Eigen::Vector2d t = target[b.target].position - target[a.target].position;
  const double scale = 1.0 / (s.norm() * t.norm());
  TwoPointMotion motion{s.dot(t) * scale, (s.x() * t.y() - s.y() * t.x()) * scale, 0.0, 0.0};
  const Eigen::Vector2d offset =
      0.5 * (target[a.target].position + target[b.target].position -
             motion * (source[a.source].position + source[b.source].position));
  motion.x = offset.x();
  motion.y = offset.y();
  return motion;
}

}  // namespace falko_slam
