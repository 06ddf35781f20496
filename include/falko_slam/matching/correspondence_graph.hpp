// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

class HeadingSearch;

struct CorrespondenceGraphParams {
  /// epsilon: two pairs are compatible if their points are equally far apart in both sets, to less
  /// than this. Also how far a segment may miss its partner sideways. (0, 10] [m]
  double distance_tolerance = 0.10;
  /// The turn from a point's own orientation to its partner's may differ from the heading of the
  /// match by at most this. Greater values forgive worse orientations. [0, 1.5] [rad]
  double orientation_gate = 1.05;
  /// Standard deviation of a coordinate's residual, for the covariance; 0: from the residuals. [m]
  double residual_noise = 0.03;
  /// Windows and nodes of the search, after which the best match so far is returned, unproven.
  std::uint64_t max_nodes = 1000000;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CorrespondenceGraphParams& params);

/// Association by the correspondence graph (\cite bailey2000data, \cite kallasi2017 4.1.2): its
/// vertices are the pairs (i_s, i_t), its edges join pairs whose points are equally far apart in
/// both sets; the match is a maximum clique.
///
/// Deviation: distances cannot tell a scan from its mirror image. A match here also needs a
/// heading: one rotation which, applied to every segment between two matched source points, leaves
/// it within asin(epsilon / length) of the direction of its partner, and which every matched point
/// with an orientation confirms to within the gate. Segments not longer than epsilon (the shorter
/// of the two counts) have no direction. Angles are exact to 2^-32 turns.
///
/// **Exact**: with `proven`, no larger set of pairs has compatible distances and such a heading.
/// Of several that large the one found first is returned. `doc/decisions/0007-chirality.md` tells
/// how, and what is promised about mirror images.
///
/// Not thread-safe: one matcher for each thread; it keeps its memory.
class CorrespondenceGraphMatcher {
 public:
  explicit CorrespondenceGraphMatcher(const CorrespondenceGraphParams& params = {});
  ~CorrespondenceGraphMatcher();
  CorrespondenceGraphMatcher(CorrespondenceGraphMatcher&&) noexcept;
  CorrespondenceGraphMatcher& operator=(CorrespondenceGraphMatcher&&) noexcept;

  MatchResult match(const std::vector<MatchPoint>& source, const std::vector<MatchPoint>& target,
                    const PairPredicate& may_match = {});

  const CorrespondenceGraphParams& params() const { return params_; }

 private:
  CorrespondenceGraphParams params_;
  std::unique_ptr<HeadingSearch> search_;
};

}  // namespace falko_slam
