// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "feature_gate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

double greatest_deviation(const Eigen::Matrix2d& covariance) {
  return std::sqrt(covariance.trace());  // or a little more
}

}  // namespace

FeatureGate::FeatureGate(const LandmarkState& state, const std::vector<FeatureRecord>& records,
                         const LandmarkIndex* map, const Pose2& base_T_laser, double gate)
    : state_(state),
      records_(records),
      map_(map),
      base_T_laser_(base_T_laser),
      gate_(gate),
      pose_(state.pose()),
      radius_(pose_, base_T_laser, map ? map->largest_deviation() : 0.0, std::sqrt(gate)) {
  for (int i = 0; i < state_.landmarks(); ++i) {
    const bool is_line = records_[static_cast<std::size_t>(i)].is_line;
    deviations_.push_back(is_line ? 0.0 : greatest_deviation(state_.covariance_of(i)));
  }
}

FeatureGate::Found FeatureGate::add(std::size_t number, const SeenFeature& seen,
                                    FeaturePairs& pairs) {
  if (map_ && !seen.is_line) {
    if (seen.id && !map_->find(*seen.id)) return Found::kUnknownId;
    if (add_of_map(number, seen, pairs)) return Found::kSome;
    if (seen.id) return Found::kNone;
  }
  return add_of_state(number, seen, pairs) ? Found::kSome : Found::kNone;
}

bool FeatureGate::add_of_map(std::size_t number, const SeenFeature& seen, FeaturePairs& pairs) {
  if (seen.id) {
    near_.assign(1, *map_->find(*seen.id));
  } else {
    const LandmarkObservation observation{
        ObservationModel::kCartesian, seen.line.value, seen.line.covariance, {}, seen.kind};
    map_->find_near(seen.in_map, radius_.of(observation), near_);
    std::sort(near_.begin(), near_.end());
  }
  bool any = false;
  for (const std::size_t place : near_) {
    const Landmark& landmark = map_->landmarks()[place];
    if (landmark.kind != seen.kind) continue;
    const LandmarkState::Row row = row_of(pose_.pose, base_T_laser_, landmark, seen);
    const auto distance = distance_of(row);
    if (!distance) continue;
    pairs.rows.push_back(row);
    pairs.joint.pairs.push_back({number, number_of(place, pairs), *distance});
    any = true;
  }
  return any;
}

std::optional<double> FeatureGate::distance_of(const LandmarkState::Row& row) const {
  const Eigen::Matrix2d S = state_.innovation_covariance(row);
  const double distance = row.innovation.dot(S.inverse() * row.innovation);
  if (!(distance <= gate_)) return std::nullopt;
  return distance;
}

// Small numbers: the search marks those that are taken.
std::size_t FeatureGate::number_of(std::size_t place, FeaturePairs& pairs) const {
  const auto known = std::find(pairs.of_map.begin(), pairs.of_map.end(), place);
  const auto index = static_cast<std::size_t>(known - pairs.of_map.begin());
  if (known == pairs.of_map.end()) pairs.of_map.push_back(place);
  const std::size_t number = records_.size() + index;
  pairs.joint.landmarks = std::max(pairs.joint.landmarks, number + 1);
  return number;
}

// A cheap look before the gate itself.
bool FeatureGate::may_be(int landmark, double reach, const SeenFeature& seen) const {
  const FeatureRecord& candidate = records_[static_cast<std::size_t>(landmark)];
  if (candidate.is_line != seen.is_line || candidate.kind != seen.kind) return false;
  const Eigen::Vector2d mean = state_.mean_of(landmark);
  if (!seen.is_line) return (mean - seen.in_map).squaredNorm() <= reach * reach;
  return overlap(mean.x(), candidate.middle, 0.5 * candidate.half_length, seen.in_map,
                 0.5 * seen.line.half_length + reach);
}

// The deviation of an innovation is at most the sum of those of pose, landmark and observation.
bool FeatureGate::add_of_state(std::size_t number, const SeenFeature& seen,
                               FeaturePairs& pairs) const {
  const double way = (seen.in_map - pose_.pose.translation()).norm();
  const double heading = std::sqrt(pose_.covariance(2, 2));
  const double own = greatest_deviation(pose_.covariance.topLeftCorner<2, 2>()) + heading * way +
                     (seen.is_line ? 0.0 : greatest_deviation(seen.line.covariance));
  const double share = std::max(0.1, 1.0 - std::sqrt(gate_) * heading);
  bool any = false;
  for (int i = 0; i < state_.landmarks(); ++i) {
    const FeatureRecord& record = records_[static_cast<std::size_t>(i)];
    const double theirs = deviations_[static_cast<std::size_t>(i)];
    if (!may_be(i, std::sqrt(gate_) * (own + theirs) / share, seen)) continue;
    LandmarkState::Row row = row_of(pose_.pose, base_T_laser_, record, state_.mean_of(i), seen);
    row.landmark = i;
    const auto distance = distance_of(row);
    if (!distance) continue;
    pairs.rows.push_back(row);
    pairs.joint.pairs.push_back({number, static_cast<std::size_t>(i), *distance});
    any = true;
  }
  return any;
}

}  // namespace falko_slam
