// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/loop_scores.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace falko_slam {
namespace {

constexpr std::size_t kNearest = 3;  // members of the other side that are looked at
constexpr std::size_t kStride = 2;   // of the points of neighbours
constexpr double kArm = 0.5;         // a turn by 1 rad counts as much as a step of this [m]

double share(std::size_t part, std::size_t all) {
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

// The agreement with the member of `others` that sees most of the scan; of its kNearest members.
Agreement best_agreement(const Neighborhood& others, const Keyframe& keyframe,
                         const Pose2& others_T_keyframe, const AgreementParams& params) {
  struct Near {
    double distance;
    const Neighborhood::Member* member;
  };
  std::vector<Near> order;
  for (const Neighborhood::Member& member : others.members) {
    const Pose2 difference = member.center_T_member.inverse() * others_T_keyframe;
    order.push_back(
        {difference.translation().norm() + kArm * std::abs(difference.theta()), &member});
  }
  const auto looked_at = static_cast<std::ptrdiff_t>(std::min(kNearest, order.size()));
  std::partial_sort(order.begin(), order.begin() + looked_at, order.end(),
                    [](const Near& a, const Near& b) { return a.distance < b.distance; });
  Agreement best;
  best.points = (keyframe.view.points().size() + kStride - 1) / kStride;
  for (auto near = order.begin(); near != order.begin() + looked_at; ++near) {
    const Agreement found =
        agreement(near->member->keyframe->view, keyframe.view,
                  near->member->center_T_member.inverse() * others_T_keyframe, params, kStride);
    if (found.seen() > best.seen()) best = found;
  }
  return best;
}

}  // namespace

double scan_score(const Agreement& forward, const Agreement& backward, double constraint) {
  constexpr double kEnoughView = 0.5;
  constexpr double kEnoughConstraint = 0.1;
  constexpr double kEnoughWall = 5.0;  // [m]
  Agreement both = forward;
  both += backward;
  const double lesser = std::min(forward.ratio(), backward.ratio());
  return std::sqrt(both.ratio() * lesser) * std::sqrt(share(both.agreeing, both.points)) *
         std::min(1.0, share(both.seen(), both.points) / kEnoughView) *
         std::min(1.0, 0.5 * both.agreeing_length / kEnoughWall) *
         std::sqrt(std::clamp(constraint / kEnoughConstraint, 0.0, 1.0));
}

Agreement neighborhood_agreement(const Neighborhood& target, const Neighborhood& source,
                                 const Pose2& target_T_source, const AgreementParams& params) {
  Agreement sum;
  const Pose2 source_T_target = target_T_source.inverse();
  for (std::size_t i = 1; i < source.members.size(); ++i) {
    const auto& [keyframe, center_T_member] = source.members[i];
    sum += best_agreement(target, *keyframe, target_T_source * center_T_member, params);
  }
  for (std::size_t i = 1; i < target.members.size(); ++i) {
    const auto& [keyframe, center_T_member] = target.members[i];
    sum += best_agreement(source, *keyframe, source_T_target * center_T_member, params);
  }
  return sum;
}

double neighborhood_score(double scan_score, const Agreement& neighbors) {
  constexpr double kEnoughAgreement = 0.6;
  const double ratio = neighbors.ratio();
  return scan_score * ratio * ratio * ratio *
         std::min(1.0, share(neighbors.agreeing, neighbors.points) / kEnoughAgreement);
}

}  // namespace falko_slam
