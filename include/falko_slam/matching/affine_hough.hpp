// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

struct AffineHoughParams {
  /// The translation is looked for in [-range, range] in x and in y; at most 2000 cells.
  /// [0.1, 100] [m]
  double range = 5.0;
  double cell = 0.10;          ///< Delta_x and Delta_y [0.01, 10] [m]
  double heading_step = 0.04;  ///< Delta_theta, rounded to a part of the circle [0.002, 1] [rad]
  /// As CorrespondenceGraphParams::orientation_gate; pi: any, as in the thesis. [0, pi] [rad]
  double orientation_gate = 1.05;
  double residual_noise = 0.03;  ///< as in CorrespondenceGraphParams [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const AffineHoughParams& params);

/// Association by the affine Hough transform (\cite kallasi2017 4.1.3, \cite ballard1981hough): at
/// every quantised heading theta_k = -pi + (k + 1/2) step each pair votes for its translation
/// t = q - R(theta_k) p (4.4); the match is what voted for the fullest block of cells.
///
/// A block is two by two neighbouring cells, and every such square counts, so that votes which
/// agree to within a cell are together in one block wherever the borders lie. The fullest block is
/// found exactly; of equally full ones that with the lowest heading, then y, then x. Of its pairs
/// those nearest to their mean translation are kept, one to one.
///
/// Deviation: all headings, not half of them, so that a place is recognised on the way back.
/// `proven` is always set, for the fullest block. `search_nodes` counts votes.
///
/// Not thread-safe: one matcher for each thread; it keeps its memory, but nothing that changes the
/// next answer.
class AffineHoughMatcher {
 public:
  explicit AffineHoughMatcher(const AffineHoughParams& params = {});
  ~AffineHoughMatcher();
  AffineHoughMatcher(AffineHoughMatcher&&) noexcept;
  AffineHoughMatcher& operator=(AffineHoughMatcher&&) noexcept;

  MatchResult match(const std::vector<MatchPoint>& source, const std::vector<MatchPoint>& target,
                    const PairPredicate& may_match = {});

  /// Votes in the fullest block of the last match: its pairs before they were made one-to-one.
  std::size_t votes() const;

  const AffineHoughParams& params() const { return params_; }

 private:
  class Votes;
  AffineHoughParams params_;
  std::unique_ptr<Votes> votes_;
};

}  // namespace falko_slam
