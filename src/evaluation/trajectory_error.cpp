// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/trajectory_error.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/alignment.hpp"

namespace falko_slam {
namespace {

// The estimated pose and the true one of the same time.
struct PosePair {
  Pose2 map_T_base;
  Pose2 truth_T_base;
};

std::vector<PosePair> pairs_of(const Trajectory& estimated, const Trajectory& truth,
                               double max_gap) {
  const TrajectoryIndex index(truth);
  const Duration gap = from_seconds(max_gap);
  std::vector<PosePair> pairs;
  for (const StampedPose& pose : estimated) {
    const auto truth_T_base = index.interpolate(pose.stamp, gap);
    if (truth_T_base) pairs.push_back({pose.map_T_base, *truth_T_base});
  }
  return pairs;
}

Pose2 alignment_of(const std::vector<PosePair>& pairs) {
  std::vector<PointPair> points;
  points.reserve(pairs.size());
  for (const PosePair& pair : pairs) {
    points.push_back({pair.truth_T_base.translation(), pair.map_T_base.translation(), 1.0});
  }
  const auto alignment = align(points);
  if (!alignment) {
    throw std::runtime_error("true and estimated trajectory cannot be aligned: they have " +
                             std::to_string(pairs.size()) + " poses of the same time in common" +
                             (pairs.size() < 2 ? "" : ", all of them in one place"));
  }
  return alignment->target_T_source.pose;
}

void add_error(const Pose2& error, PoseErrors& errors) {
  errors.translation.push_back(error.translation().norm());
  errors.rotation.push_back(std::abs(error.theta()));
}

// From each pose to the first one that lies `distance` of true way behind it.
PoseErrors relative_errors(const std::vector<PosePair>& pairs, double distance) {
  std::vector<double> way(pairs.size(), 0.0);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const Pose2 step = pairs[i - 1].truth_T_base.inverse() * pairs[i].truth_T_base;
    way[i] = way[i - 1] + step.translation().norm();
  }
  PoseErrors errors;
  std::size_t to = 0;
  for (std::size_t from = 0; from < pairs.size(); ++from) {
    while (to < pairs.size() && way[to] - way[from] < distance) ++to;
    if (to == pairs.size()) break;
    const Pose2 truth = pairs[from].truth_T_base.inverse() * pairs[to].truth_T_base;
    const Pose2 estimated = pairs[from].map_T_base.inverse() * pairs[to].map_T_base;
    add_error(truth.inverse() * estimated, errors);
  }
  return errors;
}

}  // namespace

void validate(const TrajectoryErrorParams& params) {
  require_in_range("max_gap", params.max_gap, 0.0, 1000.0);
  require_in_range("distance", params.distance, 0.001, 1000.0);
}

TrajectoryErrors evaluate_trajectory(const Trajectory& estimated, const Trajectory& truth,
                                     const TrajectoryErrorParams& params) {
  validate(params);
  const std::vector<PosePair> pairs = pairs_of(estimated, truth, params.max_gap);
  TrajectoryErrors result;
  result.missing = estimated.size() - pairs.size();
  result.truth_T_map = alignment_of(pairs);
  for (const PosePair& pair : pairs) {
    add_error(pair.truth_T_base.inverse() * (result.truth_T_map * pair.map_T_base),
              result.absolute);
  }
  result.relative = relative_errors(pairs, params.distance);
  return result;
}

}  // namespace falko_slam
