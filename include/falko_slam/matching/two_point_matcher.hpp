// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

struct TwoPointMatcherParams {
  /// Two segments are equal if their lengths differ by less. Greater values try more. [m]
  double distance_tolerance = 0.12;
  /// Points farther apart than this are no pair; also the cell of the bitmap. [0.001, 10] [m]
  double inlier_distance = 0.10;
  /// Shorter segments give no hypothesis: their heading says little. [m]
  double min_segment = 0.50;
  /// Source segments that are tried, the longest of each point first. [1, 1000000]
  int max_query_segments = 45;
  /// As CorrespondenceGraphParams::orientation_gate. [0, 1.5] [rad]
  double orientation_gate = 1.05;
  int max_matches = 3;  ///< K: matches to return at most. [1, 100]
  int min_pairs = 3;    ///< matches with fewer pairs are not returned. [2, 1000]
  /// Two matches differ in position by more than the one or in heading by more than the other.
  double separation = 0.50;           ///< [m]
  double heading_separation = 0.175;  ///< [rad]
  double residual_noise = 0.03;       ///< as in CorrespondenceGraphParams [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const TwoPointMatcherParams& params);

/// A set of points made ready to be matched with, for sets that are matched with often.
class TwoPointTarget {
 public:
  explicit TwoPointTarget(std::vector<MatchPoint> points = {},
                          const TwoPointMatcherParams& params = {});

  const std::vector<MatchPoint>& points() const { return points_; }

  struct Segment {
    float length;  ///< [m]
    std::uint32_t first, second;
    std::uint16_t first_turn, second_turn;  ///< from the segment to the orientation, 2^-16 turns
  };
  /// All pairs of points that are far enough apart, the shortest first.
  const std::vector<Segment>& segments() const { return segments_; }

 private:
  std::vector<MatchPoint> points_;
  std::vector<Segment> segments_;
};

/// The matcher of the loop detector: every source segment and every target segment of the same
/// length give two motions, a bitmap of the target counts how many source points each of them
/// brings near a target point, and the best ones that differ are refined.
///
/// The count is never too low, and what it lets through too easily (up to two cells, points 512
/// cells apart) refinement takes out: one-to-one pairs within `inlier_distance` whose orientations
/// agree, least squares, twice.
/// Mirror images do not match: only proper motions are tried. Not `proven`: several answers are
/// wanted, and only `max_query_segments` asked. `search_nodes` counts motions.
///
/// Not thread-safe: one matcher for each thread; it keeps its memory.
class TwoPointMatcher {
 public:
  explicit TwoPointMatcher(const TwoPointMatcherParams& params = {});
  ~TwoPointMatcher();
  TwoPointMatcher(TwoPointMatcher&&) noexcept;
  TwoPointMatcher& operator=(TwoPointMatcher&&) noexcept;

  /// At most `max_matches`: most pairs first, then the smallest residual.
  std::vector<MatchResult> match(const std::vector<MatchPoint>& source,
                                 const std::vector<MatchPoint>& target,
                                 const PairPredicate& may_match = {});
  /// The same, faster, with a target that was made with the same parameters. None with less than
  /// `min_pairs` (if that is more than the parameters' one).
  std::vector<MatchResult> match(const std::vector<MatchPoint>& source,
                                 const TwoPointTarget& target, std::size_t min_pairs = 0,
                                 const PairPredicate& may_match = {});

  const TwoPointMatcherParams& params() const { return params_; }

 private:
  class Search;
  TwoPointMatcherParams params_;
  std::unique_ptr<Search> search_;
};

}  // namespace falko_slam
