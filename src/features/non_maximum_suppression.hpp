// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace falko_slam {

/// A corner that passed its detector's tests, before suppression.
struct CornerCandidate {
  Eigen::Vector2d position;  ///< refined, in the laser frame [m]
  Eigen::Vector2d axis;      ///< into the corner, x along the beam
  float rank;                ///< smaller is better; not negative
  double roughness_square;   ///< of residual over height, dimensionless
  double range;              ///< of the beam [m]
  double slope;              ///< how the two sides lean: tells mirror images apart
  std::size_t beam;
};

/// A corner that stays: which candidate, and the mean position of those it speaks for.
struct KeptCorner {
  std::size_t index;
  Eigen::Vector2d position;
};

/// Greedy non-maximum suppression. Keeps its memory between scans.
class NonMaximumSuppression {
 public:
  /// Best first: what lies within `suppression_radius` of a kept candidate goes. A kept candidate
  /// moves to the mean of the candidates within `merge_radius` of it, weighted by the inverse of
  /// the squared roughness.
  ///
  /// The order of rank, range and slope does not depend on where a closed scan starts; beam numbers
  /// decide only between candidates that nothing else tells apart.
  ///
  /// The result is in the order of the candidates and valid until the next call.
  const std::vector<KeptCorner>& operator()(const std::vector<CornerCandidate>& candidates,
                                            double suppression_radius, double merge_radius);

 private:
  struct Peak {
    double x, y;  // of the best candidate
    double weight, sum_x, sum_y;
    std::size_t index;
  };

  void sort_best_first(const std::vector<CornerCandidate>& candidates);

  std::vector<std::uint64_t> order_;  // rank in the upper half, index in the lower one
  std::vector<Peak> peaks_;
  std::vector<KeptCorner> kept_;
};

}  // namespace falko_slam
