// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "one_to_one.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void choose_one_to_one(std::vector<RatedPair>& rated, std::vector<MatchPair>& chosen) {
  std::sort(rated.begin(), rated.end(), [](const RatedPair& a, const RatedPair& b) {
    return std::tie(a.square, a.pair.source, a.pair.target) <
           std::tie(b.square, b.pair.source, b.pair.target);
  });
  chosen.clear();
  for (const RatedPair& candidate : rated) {
    const bool taken = std::any_of(chosen.begin(), chosen.end(), [&](const MatchPair& pair) {
      return pair.source == candidate.pair.source || pair.target == candidate.pair.target;
    });
    if (!taken) chosen.push_back(candidate.pair);
  }
}

bool may_pair(const MatchPoint& source, const MatchPoint& target, double heading, double gate) {
  if (!source.usable() || !target.usable()) return false;
  if (!source.has_orientation() || !target.has_orientation()) return true;
  return std::abs(wrap_angle(target.orientation - source.orientation - heading)) <= gate;
}

void pair_under(const Pose2& target_T_source, const std::vector<MatchPoint>& source,
                const std::vector<MatchPoint>& target, const PairGates& gates,
                std::vector<MatchPair>& chosen) {
  std::vector<RatedPair> rated;
  for (std::size_t s = 0; s < source.size(); ++s) {
    const Eigen::Vector2d moved = target_T_source * source[s].position;
    for (std::size_t t = 0; t < target.size(); ++t) {
      const Eigen::Vector2d difference = moved - target[t].position;
      if (!(std::abs(difference.x()) <= gates.distance)) continue;  // nearly all
      const double square = difference.squaredNorm();
      if (!(square <= gates.distance * gates.distance)) continue;
      if (!may_pair(source[s], target[t], target_T_source.theta(), gates.orientation)) continue;
      if (gates.may_match && !gates.may_match(s, t)) continue;
      rated.push_back({square, {s, t}});
    }
  }
  choose_one_to_one(rated, chosen);
}

}  // namespace falko_slam
