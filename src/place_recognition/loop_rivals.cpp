// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "loop_memory.hpp"

namespace falko_slam {
namespace {

// Rivals among the candidates that were not verified before, at most.
constexpr std::size_t kMostRivals = 6;

// The middle of the walls that a scan saw: what stays in its place if a room is turned onto itself.
Eigen::Vector2d middle_of(const ScanView& view) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double length = 0.0;
  for (const SurfacePoint& point : view.points()) {
    sum += point.length * point.position;
    length += point.length;
  }
  return length > 0.0 ? Eigen::Vector2d(sum / length) : sum;
}

Pose2 turned_about(const Eigen::Vector2d& middle, double angle) {
  const Pose2 turn(0.0, 0.0, angle);
  return {middle - turn * middle, angle};
}

}  // namespace

// Targets of different drives do not: nothing says where one drive lies in the other, and places
// seen on two drives would refuse each other for ever.
bool LoopDetector::Memory::contradict(const LoopCandidate& a, const LoopCandidate& b) const {
  const Keyframe& target_a = at(a.target);
  const Keyframe& target_b = at(b.target);
  if (target_a.drive != target_b.drive) return false;
  const Pose2 difference = (target_a.mended_T_laser * a.target_T_source->pose).inverse() *
                           (target_b.mended_T_laser * b.target_T_source->pose);
  const double way = std::abs(target_a.path - target_b.path);
  const double turn = params.turn_drift * way;  // a steady one puts the end turn * way / 2 aside
  return difference.translation().norm() >
             params.contradicting_distance + (params.drift + 0.5 * turn) * way ||
         std::abs(difference.theta()) > params.contradicting_turn + turn;
}

void LoopDetector::Memory::drop_impossible(std::vector<LoopCandidate>& candidates) const {
  const auto impossible = [this](const LoopCandidate& candidate) {
    return candidate.target_T_source && !is_possible(candidate);
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), impossible),
                   candidates.end());
}

bool LoopDetector::Memory::rivals(const Keyframe& source, LoopCandidate other,
                                  const LoopCandidate& best) const {
  const double enough = params.ambiguity * best.score;
  if (!is_possible(other) || !contradict(best, other)) return false;
  if (other.scan_score <= 0.0) {
    if (verify(source, other) != LoopVerdict::kLowScore) return false;
    if (!contradict(best, other)) return false;  // alignment may have moved it there
  }
  if (other.scan_score < enough) return false;
  if (other.score <= 0.0) ask_neighbors(source, other);
  return other.score >= enough;
}

bool LoopDetector::Memory::ambiguous(const Keyframe& source,
                                     const std::vector<LoopCandidate>& candidates) {
  const LoopCandidate& best = candidates.front();
  std::size_t tried = 0;
  for (auto other = candidates.begin() + 1; other != candidates.end(); ++other) {
    const bool verified = other->scan_score > 0.0;
    if (!verified && other->verdict != LoopVerdict::kFewerPairs) continue;
    if (!verified && (!contradict(best, *other) || tried++ >= kMostRivals)) continue;
    if (rivals(source, *other, best)) return true;
  }
  const auto rivals_at = [&](const PoseEstimate& pose) {
    LoopCandidate other = best;
    other.target_T_source = pose;
    other.scan_score = other.score = 0.0;
    return rivals(source, other, best);
  };
  for (const MatchResult& match : rival_matcher.match(source.points, targets[best.target.value])) {
    if (rivals_at(*match.target_T_source)) return true;
  }
  const Eigen::Vector2d middle = middle_of(source.view);
  for (const double angle : {0.5 * kPi, kPi, -0.5 * kPi}) {
    PoseEstimate turned = *best.target_T_source;
    turned.pose = turned.pose * turned_about(middle, angle);
    if (rivals_at(turned)) return true;
  }
  return false;
}

}  // namespace falko_slam
