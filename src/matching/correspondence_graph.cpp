// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/correspondence_graph.hpp"

#include <utility>

#include "falko_slam/common/validation.hpp"
#include "heading_search.hpp"

namespace falko_slam {

void validate(const CorrespondenceGraphParams& params) {
  require_in_range("distance_tolerance", params.distance_tolerance, 1e-6, 10.0);
  require_in_range("orientation_gate", params.orientation_gate, 0.0, 1.5);
  require_in_range("residual_noise", params.residual_noise, 0.0, 10.0);
}

CorrespondenceGraphMatcher::CorrespondenceGraphMatcher(const CorrespondenceGraphParams& params)
    : params_(params), search_(std::make_unique<HeadingSearch>()) {
  validate(params_);
}
CorrespondenceGraphMatcher::~CorrespondenceGraphMatcher() = default;
CorrespondenceGraphMatcher::CorrespondenceGraphMatcher(CorrespondenceGraphMatcher&&) noexcept =
    default;
CorrespondenceGraphMatcher& CorrespondenceGraphMatcher::operator=(
    CorrespondenceGraphMatcher&&) noexcept = default;

MatchResult CorrespondenceGraphMatcher::match(const std::vector<MatchPoint>& source,
                                              const std::vector<MatchPoint>& target,
                                              const PairPredicate& may_match) {
  std::vector<MatchPair> pairs = search_->run(source, target, may_match, params_);
  MatchResult result = match_of(std::move(pairs), source, target, params_.residual_noise);
  result.proven = search_->proven();
  result.search_nodes = search_->nodes();
  return result;
}

}  // namespace falko_slam
