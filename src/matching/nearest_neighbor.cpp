// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/nearest_neighbor.hpp"

#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "one_to_one.hpp"

namespace falko_slam {
namespace {

struct Nearest {
  double square;
  std::size_t index;
};

}  // namespace

void validate(const NearestNeighborParams& params) {
  require_in_range("max_distance", params.max_distance, 1e-6, 100.0);
  require_in_range("orientation_gate", params.orientation_gate, 0.0, kPi);
  require_in_range("residual_noise", params.residual_noise, 0.0, 10.0);
}

MatchResult match_nearest_neighbors(const std::vector<MatchPoint>& source,
                                    const std::vector<MatchPoint>& target,
                                    const Pose2& target_T_source,
                                    const NearestNeighborParams& params) {
  validate(params);
  const Nearest none{params.max_distance * params.max_distance, source.size() + target.size()};
  std::vector<Nearest> of_source(source.size(), none);
  std::vector<Nearest> of_target(target.size(), none);
  const auto offer = [&](Nearest& nearest, double square, std::size_t index) {
    const bool first = nearest.index == none.index && square <= nearest.square;
    if (first || square < nearest.square) nearest = {square, index};
  };
  for (std::size_t s = 0; s < source.size(); ++s) {
    const Eigen::Vector2d moved = target_T_source * source[s].position;
    for (std::size_t t = 0; t < target.size(); ++t) {
      if (!may_pair(source[s], target[t], target_T_source.theta(), params.orientation_gate)) {
        continue;
      }
      const double square = (moved - target[t].position).squaredNorm();
      offer(of_source[s], square, t);
      offer(of_target[t], square, s);
    }
  }
  std::vector<MatchPair> pairs;
  for (std::size_t s = 0; s < source.size(); ++s) {
    const std::size_t t = of_source[s].index;
    if (t != none.index && of_target[t].index == s) pairs.push_back({s, t});
  }
  return match_of(std::move(pairs), source, target, params.residual_noise);
}

}  // namespace falko_slam
