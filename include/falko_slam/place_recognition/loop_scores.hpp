// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/place_recognition/keyframe.hpp"
#include "falko_slam/place_recognition/scan_agreement.hpp"

namespace falko_slam {

/// How well two scans fit when one is laid on the other, in [0, 1]: the geometric mean of
///   - the share of the walls in view of both that agree, and the lesser of its two directions,
///   - the share of all points that agree,
/// lowered where less than half of the points are in view of the other scan, where less than 5 m of
/// wall agree (a bare corner is everywhere), and where the walls leave a direction open (a
/// corridor): `constraint` below 0.1, see Registration.
double scan_score(const Agreement& source_in_target, const Agreement& target_in_source,
                  double constraint);

/// Keyframes around one of them, with their poses in its frame.
struct Neighborhood {
  struct Member {
    const Keyframe* keyframe;
    Pose2 center_T_member;
  };
  std::vector<Member> members;  ///< the first one is the centre
};

/// How the neighbours of both sides fit, each to the one of the other side that sees most of it;
/// the centres are left out. `target_T_source` is between the centres.
Agreement neighborhood_agreement(const Neighborhood& target, const Neighborhood& source,
                                 const Pose2& target_T_source, const AgreementParams& params = {});

/// scan_score times the cubed share of the neighbours' walls that agree, lowered where less than
/// 0.6 of their points do: look-alike rooms seldom have look-alike neighbours.
double neighborhood_score(double scan_score, const Agreement& neighbors);

}  // namespace falko_slam
