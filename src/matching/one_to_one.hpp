// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

/// A pair that may be chosen, and how badly its points fit.
struct RatedPair {
  double square;  ///< of their distance [m^2]
  MatchPair pair;
};

/// Chooses pairs until no two free points are left: the best fit first, then the best of what is
/// left; of equal ones the lowest source index, then the lowest target index. Sorts `rated`.
void choose_one_to_one(std::vector<RatedPair>& rated, std::vector<MatchPair>& chosen);

/// What makes a pair, given the pose.
struct PairGates {
  double distance;          ///< [m]
  double orientation;       ///< [rad]; NaN orientations pass
  PairPredicate may_match;  ///< empty: all may
};

/// Whether both points are usable and their orientations agree under the heading.
bool may_pair(const MatchPoint& source, const MatchPoint& target, double heading, double gate);

/// One-to-one pairs within the gates under target_T_source.
void pair_under(const Pose2& target_T_source, const std::vector<MatchPoint>& source,
                const std::vector<MatchPoint>& target, const PairGates& gates,
                std::vector<MatchPair>& chosen);

}  // namespace falko_slam
