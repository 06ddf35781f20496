// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// A point that may have a partner in another frame. One whose position is not finite, or a million
/// metres away, never has one.
struct MatchPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  /// Direction fixed to the point, any turn; NaN where it has none. [rad]
  double orientation = std::numeric_limits<double>::quiet_NaN();

  bool usable() const { return std::abs(position.x()) <= 1e6 && std::abs(position.y()) <= 1e6; }
  bool has_orientation() const { return std::isfinite(orientation); }
};

/// The same point in both sets, by its indices.
struct MatchPair {
  std::size_t source, target;
};
inline bool operator==(const MatchPair& a, const MatchPair& b) {
  return a.source == b.source && a.target == b.target;
}

/// Whether the source point and the target point with these indices may be the same one: the place
/// for descriptors. Empty: all may.
using PairPredicate = std::function<bool(std::size_t source, std::size_t target)>;

/// What a matcher found.
struct MatchResult {
  std::vector<MatchPair> pairs;  ///< one-to-one, in the order of the source points
  /// Least-squares motion of the pairs; empty, and no pairs, where there is no match.
  std::optional<PoseEstimate> target_T_source;
  double rms_residual = 0.0;  ///< of both coordinates of all pairs [m]
  /// No larger match exists under the matcher's definition of one. False where the matcher does not
  /// search exhaustively, or gave up.
  bool proven = false;
  std::uint64_t search_nodes = 0;  ///< a measure of the effort, the matcher's own

  bool found() const { return target_T_source.has_value(); }
};

/// The match of these pairs: sorted, with the least-squares pose. No match for fewer than two pairs
/// or where they leave the heading open. `residual_noise` as in `align`.
MatchResult match_of(std::vector<MatchPair> pairs, const std::vector<MatchPoint>& source,
                     const std::vector<MatchPoint>& target, double residual_noise);

}  // namespace falko_slam
