// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_memory.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

// The first look: every 4th point, roughly.
constexpr std::size_t kRoughStride = 4;
constexpr double kRoughTolerance = 0.3;  // [m]
constexpr double kRoughRatio = 0.4;
// Of lengths of way: evenly spaced keyframes shall not be neighbours by chance.
constexpr double kRounding = 1e-6;  // [m]
// Alignment may correct the keypoints' pose by this much.
constexpr double kFarthestMove = 1.0;  // [m]
constexpr double kWidestTurn = 0.35;   // [rad]

TwoPointMatcherParams one_match_each(TwoPointMatcherParams params) {
  params.max_matches = 1;
  return params;
}

bool better(const LoopCandidate& a, const LoopCandidate& b) {
  if (a.score != b.score) return a.score > b.score;
  if (a.scan_score != b.scan_score) return a.scan_score > b.scan_score;
  if (a.pairs != b.pairs) return a.pairs > b.pairs;
  return a.signature_distance < b.signature_distance;
}

}  // namespace

LoopDetector::Memory::Memory(const LoopDetectorParams& p)
    : params(p),
      builder(p.keyframe),
      matcher(one_match_each(p.matcher)),
      rival_matcher(p.matcher),
      index(p.keyframe.glare.direction_cells, 2 * p.keyframe.glare.distance_cells),
      odometry(p.odometry, p.registration, p.agreement) {}

void sort_by_score(std::vector<LoopCandidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(), better);
}

std::vector<LoopCandidate> LoopDetector::Memory::match(const Keyframe& source,
                                                       const Admission& admits) {
  std::vector<LoopCandidate> candidates;
  if (source.signature.empty()) return candidates;
  std::size_t most = 0;
  const auto nearest = index.nearest(source.signature, static_cast<std::size_t>(params.candidates),
                                     [&](KeyframeId id) { return admits(at(id)); });
  for (const SignatureMatch& found : nearest) {
    LoopCandidate candidate;
    candidate.target = found.id;
    candidate.signature_distance = found.distance;
    // Those with less than half of the pairs of another one are seldom the best: not worth the
    // time.
    for (const MatchResult& match :
         matcher.match(source.points, targets[found.id.value], most / 2)) {
      candidate.pairs = match.pairs.size();
      candidate.target_T_source = match.target_T_source;
      candidate.verdict = LoopVerdict::kFewerPairs;
      most = std::max(most, match.pairs.size());
    }
    candidates.push_back(candidate);
  }
  sort_by_score(candidates);
  return candidates;
}

LoopVerdict LoopDetector::Memory::verify(const Keyframe& source, LoopCandidate& candidate) const {
  const ScanView& target = at(candidate.target).view;
  const Pose2 guess = candidate.target_T_source->pose;
  AgreementParams rough = params.agreement;
  rough.tolerance = kRoughTolerance;
  if (agreement(target, source.view, guess, rough, kRoughStride).ratio() < kRoughRatio) {
    return LoopVerdict::kDisagrees;
  }
  const auto aligned = register_scans(target, source.view, guess, params.registration);
  if (!aligned) return LoopVerdict::kNotRegistered;
  const Pose2& pose = aligned->target_T_source.pose;
  const Pose2 move = guess.inverse() * pose;
  if (move.translation().norm() > kFarthestMove || std::abs(move.theta()) > kWidestTurn) {
    return LoopVerdict::kMovedAway;
  }
  candidate.target_T_source = aligned->target_T_source;
  candidate.rms_residual = aligned->rms_residual;
  candidate.scan_score = scan_score(
      agreement(target, source.view, pose, params.agreement),
      agreement(source.view, target, pose.inverse(), params.agreement), aligned->constraint);
  return LoopVerdict::kLowScore;
}

void LoopDetector::Memory::verify_first(const Keyframe& source,
                                        std::vector<LoopCandidate>& candidates) const {
  const std::size_t count = std::min(candidates.size(), static_cast<std::size_t>(params.verified));
  for (std::size_t i = 0; i < count; ++i) {
    if (candidates[i].target_T_source) candidates[i].verdict = verify(source, candidates[i]);
  }
  sort_by_score(candidates);
}

Neighborhood LoopDetector::Memory::neighborhood(KeyframeId center, std::size_t end) const {
  const Keyframe& middle = at(center);
  Neighborhood result;
  result.members.push_back({&middle, Pose2()});
  const auto walk = [&](std::ptrdiff_t direction) {
    double last = middle.path;
    int left = params.max_neighbors;
    for (auto i = static_cast<std::ptrdiff_t>(center.value) + direction;
         i >= 0 && i < static_cast<std::ptrdiff_t>(end) && left > 0; i += direction) {
      const Keyframe& here = keyframes[static_cast<std::size_t>(i)];
      if (here.drive != middle.drive) break;
      if (std::abs(here.path - middle.path) > params.neighborhood + kRounding) break;
      if (std::abs(here.path - last) < params.neighbor_spacing - kRounding) continue;
      result.members.push_back({&here, middle.mended_T_laser.inverse() * here.mended_T_laser});
      last = here.path;
      --left;
    }
  };
  walk(-1);
  walk(1);
  return result;
}

void LoopDetector::Memory::ask_neighbors(const Keyframe& source, LoopCandidate& candidate) const {
  // Nothing that came after the source, unless later places were asked for.
  const KeyframeId target = candidate.target;
  const std::size_t end = target < source.id ? source.id.value : keyframes.size();
  AgreementParams agreement = params.agreement;
  agreement.tolerance = params.neighbor_tolerance;
  const Agreement neighbors = neighborhood_agreement(neighborhood(target, end),
                                                     neighborhood(source.id, source.id.value + 1),
                                                     candidate.target_T_source->pose, agreement);
  candidate.score = neighborhood_score(candidate.scan_score, neighbors);
}

void LoopDetector::Memory::compare_first(const Keyframe& source,
                                         std::vector<LoopCandidate>& candidates) const {
  int left = params.compared;
  double best = 0.0;
  for (LoopCandidate& candidate : candidates) {
    if (candidate.verdict != LoopVerdict::kLowScore || left-- == 0) break;
    if (candidate.scan_score <= best) break;  // neighbours lower a score, all that follow too
    ask_neighbors(source, candidate);
    best = std::max(best, candidate.score);
    if (candidate.score > 0.0 && candidate.score >= params.min_score) {
      candidate.verdict = LoopVerdict::kNotBest;
    }
  }
  sort_by_score(candidates);
}

}  // namespace falko_slam
