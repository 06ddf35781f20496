// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

/// Two points of a set, the lower index first.
struct Segment {
  double length;     ///< [m]
  double direction;  ///< from the first point to the second [rad]
  std::uint32_t first, second;
  /// Orientations of both points relative to the direction, in 2^-32 turns: differences wrap by
  /// themselves. Meaningless where the point has no orientation.
  std::uint32_t first_turn, second_turn;
};

/// Replaces `segments` by all pairs of usable points that are at least `min_length` [m]
/// apart, the shortest first.
void find_segments(const std::vector<MatchPoint>& points, double min_length,
                   std::vector<Segment>& segments);

/// Calls visit(s, t) for all segments whose lengths differ by less than `tolerance`, by ascending
/// s, then t. Both must be sorted by length.
template <class Target, class Visit>
void for_each_equal_length(const std::vector<Segment>& source, const std::vector<Target>& target,
                           double tolerance, Visit visit) {
  std::size_t begin = 0;
  for (const Segment& s : source) {
    while (begin < target.size() && target[begin].length <= s.length - tolerance) ++begin;
    for (std::size_t t = begin; t < target.size() && target[t].length < s.length + tolerance; ++t) {
      visit(s, target[t]);
    }
  }
}

}  // namespace falko_slam
