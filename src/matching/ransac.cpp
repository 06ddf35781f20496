// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/ransac.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "one_to_one.hpp"
#include "segments.hpp"
#include "two_point_motion.hpp"

namespace falko_slam {
namespace {

// The best motion so far and how many source points support it.
struct Consensus {
  Pose2 target_T_source;
  std::size_t support = 0;
  std::uint64_t tried = 0;
};

class Hypotheses {
 public:
  Hypotheses(const std::vector<MatchPoint>& source, const std::vector<MatchPoint>& target,
             PairGates gates)
      : source_(source), target_(target), gates_(std::move(gates)) {}

  // Tries the motion given by two pairs, if they may be pairs at all.
  void try_pairs(const MatchPair& a, const MatchPair& b) {
    const TwoPointMotion motion = motion_of(a, b, source_, target_);
    const Pose2 pose = motion.pose();
    if (!fits(a, pose.theta()) || !fits(b, pose.theta())) return;
    std::size_t support = 0;
    for (std::size_t s = 0; s < source_.size(); ++s)
      support += has_partner(s, motion, pose.theta());
    ++best_.tried;
    if (support <= best_.support) return;
    best_.support = support;
    best_.target_T_source = pose;
  }

  const Consensus& best() const { return best_; }

 private:
  bool fits(const MatchPair& pair, double heading) const {
    return may_pair(source_[pair.source], target_[pair.target], heading, gates_.orientation) &&
           (!gates_.may_match || gates_.may_match(pair.source, pair.target));
  }
  bool has_partner(std::size_t s, const TwoPointMotion& motion, double heading) const {
    const Eigen::Vector2d moved = motion * source_[s].position;
    for (std::size_t t = 0; t < target_.size(); ++t) {
      const double square = (moved - target_[t].position).squaredNorm();
      if (square <= gates_.distance * gates_.distance && fits({s, t}, heading)) return true;
    }
    return false;
  }

  const std::vector<MatchPoint>& source_;
  const std::vector<MatchPoint>& target_;
  PairGates gates_;
  Consensus best_;
};

}  // namespace

void validate(const RansacParams& params) {
  require_in_range("inlier_probability", params.inlier_probability, 0.01, 0.999);
  require_in_range("success_probability", params.success_probability, 0.0, 0.999999);
  require_in_range("distance_tolerance", params.distance_tolerance, 1e-6, 10.0);
  require_in_range("inlier_distance", params.inlier_distance, 1e-6, 10.0);
  require_in_range("min_segment", params.min_segment, 1e-3, 100.0);
  require_in_range("orientation_gate", params.orientation_gate, 0.0, kPi);
  require_in_range("residual_noise", params.residual_noise, 0.0, 10.0);
}

int ransac_draws(const RansacParams& params) {
  validate(params);
  const double both = params.inlier_probability * params.inlier_probability;
  return static_cast<int>(std::ceil(std::log1p(-params.success_probability) / std::log1p(-both)));
}

MatchResult match_by_ransac(const std::vector<MatchPoint>& source,
                            const std::vector<MatchPoint>& target, std::mt19937_64& random,
                            const RansacParams& params, const PairPredicate& may_match) {
  const int draws = ransac_draws(params);
  std::vector<Segment> source_segments;
  std::vector<Segment> target_segments;
  find_segments(source, params.min_segment, source_segments);
  const double shortest = std::max(1e-3, params.min_segment - params.distance_tolerance);
  find_segments(target, shortest, target_segments);
  if (source_segments.empty() || target_segments.empty()) return {};

  const PairGates gates{params.inlier_distance, params.orientation_gate, may_match};
  Hypotheses hypotheses(source, target, gates);
  std::uniform_int_distribution<std::size_t> any(0, source_segments.size() - 1);
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<Segment> drawn{source_segments[any(random)]};
    for_each_equal_length(drawn, target_segments, params.distance_tolerance,
                          [&](const Segment& s, const Segment& t) {
                            hypotheses.try_pairs({s.first, t.first}, {s.second, t.second});
                            hypotheses.try_pairs({s.first, t.second}, {s.second, t.first});
                          });
  }
  if (hypotheses.best().support < 2) return {};

  std::vector<MatchPair> pairs;
  pair_under(hypotheses.best().target_T_source, source, target, gates, pairs);
  MatchResult result = match_of(pairs, source, target, params.residual_noise);
  if (result.found()) {
    pair_under(result.target_T_source->pose, source, target, gates, pairs);
    MatchResult refined = match_of(pairs, source, target, params.residual_noise);
    if (refined.pairs.size() >= result.pairs.size()) result = std::move(refined);
  }
  result.search_nodes = hypotheses.best().tried;
  return result;
}

}  // namespace falko_slam
