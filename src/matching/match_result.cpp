// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/match_result.hpp"

#include <algorithm>
#include <utility>

#include "falko_slam/geometry/alignment.hpp"

namespace falko_slam {

MatchResult match_of(std::vector<MatchPair> pairs, const std::vector<MatchPoint>& source,
                     const std::vector<MatchPoint>& target, double residual_noise) {
  std::sort(pairs.begin(), pairs.end(),
            [](const MatchPair& a, const MatchPair& b) { return a.source < b.source; });
  std::vector<PointPair> points;
  points.reserve(pairs.size());
  for (const MatchPair& pair : pairs) {
    points.push_back({target[pair.target].position, source[pair.source].position, 1.0});
  }
  const auto alignment = align(points, residual_noise);
  MatchResult result;
  // Points that all but coincide have a heading, but no finite covariance.
  if (!alignment || !alignment->target_T_source.covariance.allFinite()) return result;
  result.pairs = std::move(pairs);
  result.target_T_source = alignment->target_T_source;
  result.rms_residual = alignment->rms_residual;
  return result;
}

}  // namespace falko_slam
