// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "falko_slam/matching/match_result.hpp"

namespace falko_slam {

struct RansacParams {
  /// Share of the source points that have their partner in the target. Smaller values draw more
  /// often. [0.01, 0.999]
  double inlier_probability = 0.7;
  /// With which some draw consists of two such points. [0, 0.999999]
  double success_probability = 0.99;
  /// A drawn segment is tried with all target segments of the same length to within this. [m]
  double distance_tolerance = 0.10;
  /// Points farther apart than this are no pair. [m]
  double inlier_distance = 0.10;
  /// Shorter segments are not drawn: their heading says little. [m]
  double min_segment = 0.50;
  /// As CorrespondenceGraphParams::orientation_gate; pi: any. [0, pi] [rad]
  double orientation_gate = 1.05;
  double residual_noise = 0.03;  ///< as in CorrespondenceGraphParams [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const RansacParams& params);

/// log(1 - success) / log(1 - inlier^2), rounded up: so many draws of two points, one of them free
/// of outliers with the success probability (\cite fischler1981ransac).
int ransac_draws(const RansacParams& params);

/// Association by random sampling: two source points are drawn, each target segment of the same
/// length gives two motions, the one under which most source points have a target point nearby
/// wins; its one-to-one pairs and their least-squares pose are refined once.
///
/// Deviation: without descriptors a drawn *pair* would be right once in (target points) times only.
/// Here points are drawn and all their partners tried, so the inlier probability is that of a
/// point. Motions are proper ones: mirror images do not match. Not `proven`.
MatchResult match_by_ransac(const std::vector<MatchPoint>& source,
                            const std::vector<MatchPoint>& target, std::mt19937_64& random,
                            const RansacParams& params = {}, const PairPredicate& may_match = {});

}  // namespace falko_slam
