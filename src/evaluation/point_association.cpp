// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/point_association.hpp"

#include <algorithm>

namespace falko_slam {

std::vector<AssociatedPair> associate_greedily(const std::vector<Eigen::Vector2d>& first,
                                               const std::vector<Eigen::Vector2d>& second,
                                               double radius) {
  struct Candidate {
    double square;
    AssociatedPair pair;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      const double square = (first[i] - second[j]).squaredNorm();
      if (square <= radius * radius) candidates.push_back({square, {i, j}});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.square < b.square; });
  std::vector<bool> first_taken(first.size());
  std::vector<bool> second_taken(second.size());
  std::vector<AssociatedPair> pairs;
  for (const Candidate& candidate : candidates) {
    const auto [i, j] = candidate.pair;
    if (first_taken[i] || second_taken[j]) continue;
    first_taken[i] = true;
    second_taken[j] = true;
    pairs.push_back({i, j});
  }
  return pairs;
}

std::vector<Eigen::Vector2d> positions(const std::vector<Keypoint>& keypoints,
                                       const Pose2& map_T_laser) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(keypoints.size());
  for (const Keypoint& keypoint : keypoints) points.push_back(map_T_laser * keypoint.position);
  return points;
}

double repeatability(const std::vector<Eigen::Vector2d>& first,
                     const std::vector<Eigen::Vector2d>& second, double radius) {
  if (second.empty()) return 0.0;
  return static_cast<double>(associate_greedily(first, second, radius).size()) /
         static_cast<double>(std::min(first.size(), second.size()));
}

}  // namespace falko_slam
