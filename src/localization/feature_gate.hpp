// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "falko_slam/localization/landmark_index.hpp"
#include "gate_radius.hpp"
#include "joint_search.hpp"
#include "landmark_state.hpp"
#include "seen_feature.hpp"

namespace falko_slam {

/// Features and landmarks that may belong together. Landmarks of the state have their own numbers
/// in `joint`; those of the map come after them.
struct FeaturePairs {
  std::vector<LandmarkState::Row> rows;
  JointPairs joint;                 ///< a pair for each row
  std::vector<std::size_t> of_map;  ///< places in the map, by number in `joint`
};

/// Finds the landmarks, of a state and of a map, inside of whose gate a feature lies.
class FeatureGate {
 public:
  /// `map` may be null. `gate`: of the squared Mahalanobis distance. All must outlive this.
  FeatureGate(const LandmarkState& state, const std::vector<FeatureRecord>& records,
              const LandmarkIndex* map, const Pose2& base_T_laser, double gate);

  enum class Found { kNone, kSome, kUnknownId };
  /// Appends its pairs. Where the map has one the state is not asked: what is in the map does not
  /// get into the state.
  Found add(std::size_t number, const SeenFeature& seen, FeaturePairs& pairs);

 private:
  bool add_of_map(std::size_t number, const SeenFeature& seen, FeaturePairs& pairs);
  bool add_of_state(std::size_t number, const SeenFeature& seen, FeaturePairs& pairs) const;
  /// Squared Mahalanobis distance of the innovation; nothing beyond the gate.
  std::optional<double> distance_of(const LandmarkState::Row& row) const;
  bool may_be(int landmark, double reach, const SeenFeature& seen) const;
  std::size_t number_of(std::size_t place, FeaturePairs& pairs) const;

  const LandmarkState& state_;
  const std::vector<FeatureRecord>& records_;
  const LandmarkIndex* map_;
  const Pose2& base_T_laser_;
  double gate_;
  PoseEstimate pose_;
  GateRadius radius_;
  std::vector<double> deviations_;  // greatest one of each landmark of the state that is a point
  std::vector<std::size_t> near_;
};

}  // namespace falko_slam
