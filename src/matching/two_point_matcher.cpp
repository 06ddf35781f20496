// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/two_point_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "one_to_one.hpp"
#include "point_bitmap.hpp"
#include "segments.hpp"
#include "two_point_motion.hpp"

namespace falko_slam {
namespace {

// How often each wanted match may be looked for in vain.
constexpr std::size_t kTriesPerMatch = 8;
constexpr int kRefinements = 2;

// How much support a hypothesis needs to be refined: as long as one match is wanted, more than
// `tries` better ones leave it no chance.
class SupportBar {
 public:
  void reset(std::size_t least, std::size_t most, std::size_t tries) {
    needed_ = least;
    tries_ = tries;
    better_ = 0;
    counts_.assign(most + 1, 0);
  }
  std::size_t needed() const { return needed_; }
  void pass(std::size_t support) {
    ++counts_[support];
    if (support > needed_) ++better_;
    while (better_ >= tries_) better_ -= counts_[++needed_];
  }

 private:
  std::size_t needed_ = 0;
  std::size_t tries_ = 0;
  std::size_t better_ = 0;  // than needed_
  std::vector<std::size_t> counts_;
};

// Whether two orientations may be the same one, each being given from the direction of its segment,
// in 2^-32 turns and in 2^-16 turns.
class OrientationGate {
 public:
  explicit OrientationGate(double gate)
      : gate_(static_cast<std::uint32_t>(gate / kTwoPi * 65536.0)) {}
  bool near(std::uint32_t source_turn, std::uint16_t target_turn) const {
    const std::uint32_t difference = (source_turn >> 16) - target_turn + gate_;
    return static_cast<std::uint16_t>(difference) <= 2 * gate_;
  }
  /// If the target's segment is taken from its other end.
  bool near_opposite(std::uint32_t source_turn, std::uint16_t target_turn) const {
    return near(source_turn + (1U << 31), target_turn);
  }

 private:
  std::uint32_t gate_;
};

bool by_length(const Segment& a, const Segment& b) {
  return std::tie(a.length, a.first, a.second) < std::tie(b.length, b.first, b.second);
}

}  // namespace

void validate(const TwoPointMatcherParams& params) {
  require_in_range("distance_tolerance", params.distance_tolerance, 1e-6, 10.0);
  require_in_range("inlier_distance", params.inlier_distance, 1e-3, 10.0);
  require_in_range("min_segment", params.min_segment, 1e-3, 100.0);
  require_in_range("max_query_segments", params.max_query_segments, 1, 1000000);
  require_in_range("orientation_gate", params.orientation_gate, 0.0, 1.5);
  require_in_range("max_matches", params.max_matches, 1, 100);
  require_in_range("min_pairs", params.min_pairs, 2, 1000);
  require_in_range("separation", params.separation, 0.0, 100.0);
  require_in_range("heading_separation", params.heading_separation, 0.0, kPi);
  require_in_range("residual_noise", params.residual_noise, 0.0, 10.0);
}

TwoPointTarget::TwoPointTarget(std::vector<MatchPoint> points, const TwoPointMatcherParams& params)
    : points_(std::move(points)) {
  std::vector<falko_slam::Segment> exact;
  find_segments(points_, std::max(1e-3, params.min_segment - params.distance_tolerance), exact);
  segments_.reserve(exact.size());
  for (const falko_slam::Segment& segment : exact) {
    segments_.push_back({static_cast<float>(segment.length), segment.first, segment.second,
                         static_cast<std::uint16_t>(segment.first_turn >> 16),
                         static_cast<std::uint16_t>(segment.second_turn >> 16)});
  }
}

class TwoPointMatcher::Search {
 public:
  explicit Search(const TwoPointMatcherParams& params)
      : params_(params), bitmap_(params.inlier_distance) {}

  std::vector<MatchResult> run(const std::vector<MatchPoint>& source, const TwoPointTarget& target,
                               std::size_t min_pairs, const PairPredicate& may_match);

 private:
  struct Hypothesis {
    TwoPointMotion target_T_source;
    std::size_t support;
  };

  void prepare(const std::vector<MatchPoint>& source);
  void choose_query_segments(std::size_t points);
  void find_hypotheses(const std::vector<MatchPoint>& source, const TwoPointTarget& target,
                       std::size_t min_pairs, const PairPredicate& may_match);
  void count_support(const TwoPointMotion& motion);
  MatchResult refine(const Hypothesis& hypothesis, const std::vector<MatchPoint>& source,
                     const std::vector<MatchPoint>& target, const PairGates& gates);
  bool known(const Pose2& pose, const std::vector<MatchResult>& matches) const;

  TwoPointMatcherParams params_;
  PointBitmap bitmap_;
  std::vector<MatchPoint> source_;                 // that query_ was chosen from
  std::vector<Eigen::Vector2d> source_positions_;  // of the usable ones
  std::vector<char> source_oriented_, target_oriented_;
  std::vector<Segment> unasked_, query_;
  std::vector<std::size_t> uses_;
  std::vector<Hypothesis> hypotheses_;
  SupportBar bar_;
  std::vector<MatchPair> pairs_;
};

// One scan is often matched with many: what is known of the last source is kept.
void TwoPointMatcher::Search::prepare(const std::vector<MatchPoint>& source) {
  const auto same = [](const MatchPoint& a, const MatchPoint& b) {
    return a.position == b.position &&
           (a.orientation == b.orientation || (!a.has_orientation() && !b.has_orientation()));
  };
  if (std::equal(source.begin(), source.end(), source_.begin(), source_.end(), same)) return;
  source_ = source;
  source_oriented_.clear();
  source_positions_.clear();
  for (const MatchPoint& point : source) {
    source_oriented_.push_back(point.has_orientation());
    if (point.usable()) source_positions_.push_back(point.position);
  }
  find_segments(source, params_.min_segment, unasked_);
  choose_query_segments(source.size());
}

// The longest segments, but each point in turn: none is asked the (n + 1)-th time while a segment
// between two points asked less than n times is left.
void TwoPointMatcher::Search::choose_query_segments(std::size_t points) {
  const auto wanted = static_cast<std::size_t>(params_.max_query_segments);
  query_.clear();
  uses_.assign(points, 0);
  for (std::size_t round = 1; query_.size() < wanted && !unasked_.empty(); ++round) {
    std::size_t left = unasked_.size();  // not asked yet: the entries from here on
    for (std::size_t i = unasked_.size(); i-- > 0;) {
      const Segment segment = unasked_[i];
      const bool take =
          query_.size() < wanted && uses_[segment.first] < round && uses_[segment.second] < round;
      if (!take) {
        unasked_[--left] = segment;
        continue;
      }
      query_.push_back(segment);
      ++uses_[segment.first];
      ++uses_[segment.second];
    }
    unasked_.erase(unasked_.begin(), unasked_.begin() + static_cast<std::ptrdiff_t>(left));
  }
  std::sort(query_.begin(), query_.end(), by_length);
}

// Gives up where too few points are left to reach the bar; asks seldom, since that is hard to
// foresee.
void TwoPointMatcher::Search::count_support(const TwoPointMotion& motion) {
  constexpr std::size_t kBlock = 8;
  const std::size_t count = source_positions_.size();
  std::size_t support = 0;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    if (support + (count - begin) < bar_.needed()) return;
    const std::size_t end = std::min(begin + kBlock, count);
    for (std::size_t i = begin; i < end; ++i) {
      support += bitmap_.near_marked(motion * source_positions_[i]) ? 1U : 0U;
    }
  }
  if (support < bar_.needed()) return;
  hypotheses_.push_back({motion, support});
  bar_.pass(support);
}

void TwoPointMatcher::Search::find_hypotheses(const std::vector<MatchPoint>& source,
                                              const TwoPointTarget& target, std::size_t min_pairs,
                                              const PairPredicate& may_match) {
  const OrientationGate gate(params_.orientation_gate);
  const auto oriented = [&](const MatchPair& pair) {
    return source_oriented_[pair.source] && target_oriented_[pair.target];
  };
  const auto may_pair = [&](const MatchPair& pair, bool near) {
    return (near || !oriented(pair)) && (!may_match || may_match(pair.source, pair.target));
  };
  const auto try_pairs = [&](const MatchPair& a, bool a_near, const MatchPair& b, bool b_near) {
    if (may_pair(a, a_near) && may_pair(b, b_near)) {
      count_support(motion_of(a, b, source, target.points()));
    }
  };
  const auto all = [](const std::vector<char>& flags) {
    return std::find(flags.begin(), flags.end(), 0) == flags.end();
  };
  const bool all_oriented = all(source_oriented_) && all(target_oriented_);
  const auto wanted = static_cast<std::size_t>(params_.max_matches);
  const std::size_t tries = wanted == 1 ? kTriesPerMatch : std::numeric_limits<std::size_t>::max();
  bar_.reset(min_pairs, source_positions_.size(), tries);
  hypotheses_.clear();
  const auto visit = [&](const Segment& s, const TwoPointTarget::Segment& t) {
    const bool first = gate.near(s.first_turn, t.first_turn);
    const bool second = gate.near(s.second_turn, t.second_turn);
    const bool first_crossed = gate.near_opposite(s.first_turn, t.second_turn);
    const bool second_crossed = gate.near_opposite(s.second_turn, t.first_turn);
    // Most segments do not fit, and nothing foretells which: one branch for all of it.
    if (all_oriented && !((first & second) | (first_crossed & second_crossed))) return;
    try_pairs({s.first, t.first}, first, {s.second, t.second}, second);
    try_pairs({s.first, t.second}, first_crossed, {s.second, t.first}, second_crossed);
  };
  for_each_equal_length(query_, target.segments(), params_.distance_tolerance, visit);
}

MatchResult TwoPointMatcher::Search::refine(const Hypothesis& hypothesis,
                                            const std::vector<MatchPoint>& source,
                                            const std::vector<MatchPoint>& target,
                                            const PairGates& gates) {
  Pose2 pose = hypothesis.target_T_source.pose();
  MatchResult result;
  for (int i = 0; i <= kRefinements; ++i) {
    pair_under(pose, source, target, gates, pairs_);
    result = match_of(pairs_, source, target, params_.residual_noise);
    if (!result.found()) break;
    pose = result.target_T_source->pose;
  }
  return result;
}

bool TwoPointMatcher::Search::known(const Pose2& pose,
                                    const std::vector<MatchResult>& matches) const {
  return std::any_of(matches.begin(), matches.end(), [&](const MatchResult& match) {
    const Pose2& other = match.target_T_source->pose;
    return (pose.translation() - other.translation()).norm() <= params_.separation &&
           std::abs(angle_between(pose.theta(), other.theta())) <= params_.heading_separation;
  });
}

std::vector<MatchResult> TwoPointMatcher::Search::run(const std::vector<MatchPoint>& source,
                                                      const TwoPointTarget& target_set,
                                                      std::size_t min_pairs,
                                                      const PairPredicate& may_match) {
  const std::vector<MatchPoint>& target = target_set.points();
  const std::size_t fewest = std::max(min_pairs, static_cast<std::size_t>(params_.min_pairs));
  prepare(source);
  target_oriented_.clear();
  for (const MatchPoint& point : target) {
    target_oriented_.push_back(point.has_orientation());
    if (point.usable()) bitmap_.mark(point.position);
  }
  find_hypotheses(source, target_set, fewest, may_match);
  bitmap_.clear();

  const PairGates gates{params_.inlier_distance, params_.orientation_gate, may_match};
  const auto wanted = static_cast<std::size_t>(params_.max_matches);
  std::vector<MatchResult> matches;
  std::size_t tries = 0;
  for (std::size_t support = source.size(); support >= fewest; --support) {
    // Of equal support the longest segments first: theirs is the best heading.
    for (auto hypothesis = hypotheses_.rbegin(); hypothesis != hypotheses_.rend(); ++hypothesis) {
      if (hypothesis->support != support) continue;
      if (matches.size() == wanted || tries == wanted * kTriesPerMatch) break;
      if (known(hypothesis->target_T_source.pose(), matches)) continue;
      ++tries;
      MatchResult match = refine(*hypothesis, source, target, gates);
      const std::size_t pairs = match.pairs.size();
      if (pairs < static_cast<std::size_t>(params_.min_pairs)) continue;
      if (pairs < fewest && wanted == 1) return {};  // the best one has too few
      if (pairs < fewest || known(match.target_T_source->pose, matches)) continue;
      match.search_nodes = hypotheses_.size();
      matches.push_back(std::move(match));
    }
  }
  std::stable_sort(matches.begin(), matches.end(), [](const MatchResult& a, const MatchResult& b) {
    if (a.pairs.size() != b.pairs.size()) return a.pairs.size() > b.pairs.size();
    return a.rms_residual < b.rms_residual;
  });
  return matches;
}

TwoPointMatcher::TwoPointMatcher(const TwoPointMatcherParams& params)
    : params_((validate(params), params)), search_(std::make_unique<Search>(params)) {}
TwoPointMatcher::~TwoPointMatcher() = default;
TwoPointMatcher::TwoPointMatcher(TwoPointMatcher&&) noexcept = default;
TwoPointMatcher& TwoPointMatcher::operator=(TwoPointMatcher&&) noexcept = default;

std::vector<MatchResult> TwoPointMatcher::match(const std::vector<MatchPoint>& source,
                                                const std::vector<MatchPoint>& target,
                                                const PairPredicate& may_match) {
  return search_->run(source, TwoPointTarget(target, params_), 0, may_match);
}

std::vector<MatchResult> TwoPointMatcher::match(const std::vector<MatchPoint>& source,
                                                const TwoPointTarget& target, std::size_t min_pairs,
                                                const PairPredicate& may_match) {
  return search_->run(source, target, min_pairs, may_match);
}

}  // namespace falko_slam
