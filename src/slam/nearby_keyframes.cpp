// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/nearby_keyframes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void validate(const NearbyKeyframesParams& params) {
  require_in_range("max_distance", params.max_distance, 0.1, 100.0);
  require_in_range("max_turn", params.max_turn, 0.1, kPi);
  require_in_range("spacing", params.spacing, 0.0, 100.0);
  require_in_range("min_path", params.min_path, 0.0, 1000.0);
  require_in_range("count", params.count, 1, 100);
  require_in_range("max_drift", params.max_drift, 0.0, 10.0);
}

NearbyKeyframes::NearbyKeyframes(const NearbyKeyframesParams& params)
    : params_((validate(params), params)) {}

void NearbyKeyframes::add(double path, bool all_around) {
  nodes_.push_back({path, all_around, {}});
}

void NearbyKeyframes::connect(KeyframeId a, KeyframeId b, const Eigen::Matrix3d& covariance) {
  const double place = covariance.topLeftCorner<2, 2>().trace();
  const double turn = covariance(2, 2);
  nodes_.at(a.value).links.push_back({static_cast<std::size_t>(b.value), place, turn});
  nodes_.at(b.value).links.push_back({static_cast<std::size_t>(a.value), place, turn});
}

// Dijkstra's search over variances, which add up along a chain. The error of a link's turn moves
// what lies beyond it by its distance from there; what is asked for lies near the source, so this
// is the distance from the source.
template <class Visit>
void NearbyKeyframes::search_from(std::size_t source, const std::vector<Pose2>& poses, double limit,
                                  const Visit& visit) {
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  ++searches_;
  const auto reach = [&](std::size_t at, double variance) {
    Node& node = nodes_[at];
    if (node.search == searches_ && node.variance <= variance) return;
    if (node.search != searches_) node.settled = false;
    node.search = searches_;
    node.variance = variance;
    queue.emplace(variance, at);
  };
  reach(source, 0.0);
  while (!queue.empty()) {
    const auto [variance, at] = queue.top();
    queue.pop();
    Node& node = nodes_[at];
    if (node.settled) continue;
    node.settled = true;
    if (visit(at, variance)) return;
    const double arm = (poses[at].translation() - poses[source].translation()).squaredNorm();
    for (const Link& link : node.links) {
      const double sum = variance + link.place_variance + arm * link.turn_variance;
      if (sum <= limit * limit) reach(link.to, sum);
    }
  }
}

// Those near enough by their poses, the nearest first.
std::vector<std::size_t> NearbyKeyframes::candidates(std::size_t source,
                                                     const std::vector<Pose2>& poses) const {
  constexpr double kArm = 1.0;  // a turn by 1 rad counts as much as a step of this [m]
  std::vector<std::pair<double, std::size_t>> found;
  const Node& from = nodes_[source];
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (i == source || std::abs(from.path - nodes_[i].path) < params_.min_path) continue;
    const double distance = (poses[i].translation() - poses[source].translation()).norm();
    if (distance > params_.max_distance) continue;
    const double turn = std::abs(angle_between(poses[source].theta(), poses[i].theta()));
    const bool any_turn = from.all_around && nodes_[i].all_around;
    if (turn > params_.max_turn && !any_turn) continue;
    found.emplace_back(distance + (any_turn ? 0.0 : kArm * turn), i);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> order;
  order.reserve(found.size());
  for (const auto& [distance, i] : found) order.push_back(i);
  return order;
}

std::vector<NearbyKeyframe> NearbyKeyframes::find(KeyframeId source,
                                                  const std::vector<Pose2>& poses) {
  std::vector<NearbyKeyframe> result;
  const std::vector<std::size_t> near = candidates(source.value, poses);
  if (near.empty()) return result;
  std::size_t left = near.size();
  std::vector<bool> wanted(nodes_.size(), false);
  for (const std::size_t i : near) wanted[i] = true;
  search_from(source.value, poses, params_.max_drift,
              [&](std::size_t at, double) { return wanted[at] && --left == 0; });
  for (const std::size_t i : near) {
    if (nodes_[i].search != searches_ || !nodes_[i].settled) continue;
    const bool beside = std::any_of(result.begin(), result.end(), [&](const NearbyKeyframe& other) {
      return std::abs(path(other.id) - nodes_[i].path) < params_.spacing;
    });
    if (!beside) result.push_back({{i}, std::sqrt(nodes_[i].variance)});
    if (result.size() >= static_cast<std::size_t>(params_.count)) break;
  }
  return result;
}

std::optional<double> NearbyKeyframes::drift(KeyframeId source, KeyframeId target,
                                             const std::vector<Pose2>& poses, double limit) {
  std::optional<double> result;
  search_from(source.value, poses, limit, [&](std::size_t at, double variance) {
    if (at != target.value) return false;
    result = std::sqrt(variance);
    return true;
  });
  return result;
}

std::vector<double> NearbyKeyframes::drifts(KeyframeId source, const std::vector<Pose2>& poses) {
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  std::vector<double> result(nodes_.size(), kAnywhere);
  search_from(source.value, poses, kAnywhere, [&](std::size_t at, double variance) {
    result[at] = std::sqrt(variance);
    return false;
  });
  return result;
}

}  // namespace falko_slam
