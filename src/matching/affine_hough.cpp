// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/affine_hough.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "heading_arc.hpp"
#include "one_to_one.hpp"

namespace falko_slam {

void validate(const AffineHoughParams& params) {
  require_in_range("range", params.range, 0.1, 100.0);
  require_in_range("cell", params.cell, 0.01, 10.0);
  require_in_range("range / cell", params.range / params.cell, 1.0, 2000.0);
  require_in_range("heading_step", params.heading_step, 0.002, 1.0);
  require_in_range("orientation_gate", params.orientation_gate, 0.0, kPi);
  require_in_range("residual_noise", params.residual_noise, 0.0, 10.0);
}

// The accumulator of one heading at a time, and the fullest block of all.
class AffineHoughMatcher::Votes {
 public:
  explicit Votes(const AffineHoughParams& params)
      : params_(params),
        headings_(static_cast<int>(std::lround(kTwoPi / params.heading_step))),
        cells_(static_cast<std::int64_t>(std::ceil(2.0 * params.range / params.cell))),
        blocks_(static_cast<std::size_t>((cells_ + 1) * (cells_ + 1)), 0) {}

  void find_fullest_block(const std::vector<MatchPoint>& source,
                          const std::vector<MatchPoint>& target, const PairPredicate& may_match);
  std::vector<MatchPair> pairs_of_fullest_block(const std::vector<MatchPoint>& source);

  std::size_t fullest() const { return fullest_.votes; }
  std::uint64_t cast() const { return cast_; }

 private:
  // A pair votes at the headings from `begin` to begin + extent.
  struct Voter {
    HeadingArc headings;
    std::uint32_t source, target;
    double x, y;  // of the target point
  };
  struct Block {
    std::uint32_t votes = 0;
    int heading = 0;
    std::size_t index = 0;  // row by row
  };
  struct Vote {
    std::uint32_t voter;
    std::size_t block;  // of the four that hold its cell the lowest one
    double x, y;        // the translation [m]
  };

  void find_voters(const std::vector<MatchPoint>& source, const std::vector<MatchPoint>& target,
                   const PairPredicate& may_match);
  void cast_votes(int heading, const std::vector<MatchPoint>& source);
  void count_votes(int heading);
  double angle(int heading) const { return -kPi + (heading + 0.5) * kTwoPi / headings_; }
  // Cell c lies in the blocks c and c + 1 of its row or column.
  std::size_t row() const { return static_cast<std::size_t>(cells_ + 1); }

  AffineHoughParams params_;
  int headings_;
  std::int64_t cells_;  // in a row
  std::vector<std::uint32_t> blocks_;
  std::vector<Voter> voters_;
  std::vector<Eigen::Vector2d> turned_;
  std::vector<Vote> ballot_;
  Block fullest_;
  std::uint64_t cast_ = 0;
};

void AffineHoughMatcher::Votes::find_voters(const std::vector<MatchPoint>& source,
                                            const std::vector<MatchPoint>& target,
                                            const PairPredicate& may_match) {
  const bool gated = params_.orientation_gate < kPi;
  const auto gate = static_cast<BinaryAngle>(params_.orientation_gate / kTwoPi * kBinaryTurn);
  voters_.clear();
  for (std::uint32_t s = 0; s < source.size(); ++s) {
    for (std::uint32_t t = 0; t < target.size(); ++t) {
      if (!source[s].usable() || !target[t].usable()) continue;
      if (may_match && !may_match(s, t)) continue;
      Voter voter{{}, s, t, target[t].position.x(), target[t].position.y()};
      if (gated && source[s].has_orientation() && target[t].has_orientation()) {
        voter.headings = arc_around(
            binary_angle(target[t].orientation) - binary_angle(source[s].orientation), gate);
      }
      voters_.push_back(voter);
    }
  }
}

// Replaces the ballot by the votes at this heading, (4.4), that fall into the range.
void AffineHoughMatcher::Votes::cast_votes(int heading, const std::vector<MatchPoint>& source) {
  const double theta = angle(heading);
  const BinaryAngle theta_binary = binary_angle(theta);
  const Pose2 rotation(0.0, 0.0, theta);
  turned_.clear();
  for (const MatchPoint& point : source) turned_.push_back(rotation * point.position);
  const double per_metre = 1.0 / params_.cell;
  ballot_.resize(voters_.size());
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < voters_.size(); ++i) {
    const Voter& voter = voters_[i];
    if (theta_binary - voter.headings.begin > voter.headings.extent) continue;
    const double x = voter.x - turned_[voter.source].x();
    const double y = voter.y - turned_[voter.source].y();
    // One cell more, and truncation rounds down wherever it matters.
    const auto column = static_cast<std::int64_t>((x + params_.range) * per_metre + 1.0);
    const auto line = static_cast<std::int64_t>((y + params_.range) * per_metre + 1.0);
    if (column < 1 || column > cells_ || line < 1 || line > cells_) continue;
    const auto block = static_cast<std::size_t>((line - 1) * (cells_ + 1) + column - 1);
    ballot_[count++] = {i, block, x, y};
  }
  ballot_.resize(count);
}

// Leaves the accumulator empty.
void AffineHoughMatcher::Votes::count_votes(int heading) {
  const std::size_t beside[] = {0, 1, row(), row() + 1};
  std::uint32_t most = 0;
  for (const Vote& vote : ballot_) {
    for (const std::size_t step : beside) most = std::max(most, ++blocks_[vote.block + step]);
  }
  if (most > fullest_.votes) {
    fullest_ = {most, heading, blocks_.size()};
    for (const Vote& vote : ballot_) {
      for (const std::size_t step : beside) {
        const std::size_t block = vote.block + step;
        if (blocks_[block] == most) fullest_.index = std::min(fullest_.index, block);
      }
    }
  }
  for (const Vote& vote : ballot_) {
    for (const std::size_t step : beside) blocks_[vote.block + step] = 0;
  }
}

void AffineHoughMatcher::Votes::find_fullest_block(const std::vector<MatchPoint>& source,
                                                   const std::vector<MatchPoint>& target,
                                                   const PairPredicate& may_match) {
  fullest_ = {};
  cast_ = 0;
  find_voters(source, target, may_match);
  for (int heading = 0; heading < headings_; ++heading) {
    cast_votes(heading, source);
    count_votes(heading);
    cast_ += ballot_.size();
  }
}

std::vector<MatchPair> AffineHoughMatcher::Votes::pairs_of_fullest_block(
    const std::vector<MatchPoint>& source) {
  std::vector<MatchPair> pairs;
  if (fullest_.votes < 2) return pairs;
  cast_votes(fullest_.heading, source);
  const auto outside = [&](const Vote& vote) {
    const std::size_t step = fullest_.index - vote.block;  // huge if negative
    return step != 0 && step != 1 && step != row() && step != row() + 1;
  };
  ballot_.erase(std::remove_if(ballot_.begin(), ballot_.end(), outside), ballot_.end());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Vote& vote : ballot_) mean += Eigen::Vector2d(vote.x, vote.y);
  mean /= static_cast<double>(ballot_.size());
  std::vector<RatedPair> rated;
  for (const Vote& vote : ballot_) {
    const Voter& voter = voters_[vote.voter];
    rated.push_back(
        {(Eigen::Vector2d(vote.x, vote.y) - mean).squaredNorm(), {voter.source, voter.target}});
  }
  choose_one_to_one(rated, pairs);
  return pairs;
}

AffineHoughMatcher::AffineHoughMatcher(const AffineHoughParams& params)
    : params_((validate(params), params)), votes_(std::make_unique<Votes>(params)) {}
AffineHoughMatcher::~AffineHoughMatcher() = default;
AffineHoughMatcher::AffineHoughMatcher(AffineHoughMatcher&&) noexcept = default;
AffineHoughMatcher& AffineHoughMatcher::operator=(AffineHoughMatcher&&) noexcept = default;

std::size_t AffineHoughMatcher::votes() const { return votes_->fullest(); }

MatchResult AffineHoughMatcher::match(const std::vector<MatchPoint>& source,
                                      const std::vector<MatchPoint>& target,
                                      const PairPredicate& may_match) {
  votes_->find_fullest_block(source, target, may_match);
  MatchResult result =
      match_of(votes_->pairs_of_fullest_block(source), source, target, params_.residual_noise);
  result.proven = true;
  result.search_nodes = votes_->cast();
  return result;
}

}  // namespace falko_slam
