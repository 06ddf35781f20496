// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/landmark_index.hpp"
#include "falko_slam/localization/measurement_model.hpp"

namespace falko_slam {

/// When an observation may be taken for a landmark.
struct AssociationParams {
  /// Probability that a right pair passes its own chi-square gate. Greater: fewer are lost when the
  /// noise is worse than told, more are mistaken. [0.5, 0.999999]
  double gate_probability = 0.997;
  /// The same of all pairs together. [0.5, 0.999999]
  double joint_probability = 0.999;
  /// Another set of as many pairs is a rival if its squared Mahalanobis distance is greater by no
  /// more than this: 6 means e^3 times less likely. Pairs that rivals do not share are refused.
  /// Greater: more is refused. [0, 1000]
  double ambiguity = 6.0;
  /// Steps of the search for the largest joint set; what it found by then is taken. [1, 1000000]
  int max_nodes = 1000;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const AssociationParams& params);

/// What became of an observation.
enum class ObservationVerdict {
  kUsed,
  kInvalid,       ///< not finite, no positive definite covariance, or a range not above zero
  kUnknownId,     ///< the map has no landmark of its id
  kNoLandmark,    ///< none inside of its gate, or not the one of its id
  kIncompatible,  ///< one inside, but not together with those of the others
  kAmbiguous,     ///< more than one set of pairs is likely, and they differ here
  kTentative,     ///< of a landmark that may become one: LandmarkFilter
  kAdded,         ///< of one that has just become one
  kTooNear,       ///< of none, but too near to one to tell them apart later
};
const char* name_of(ObservationVerdict verdict);
/// It could have been used, but there is no landmark for it.
bool fits_nothing(ObservationVerdict verdict);

/// An observation and a landmark that may belong together.
struct LandmarkPair {
  std::size_t observation = 0;                           ///< place among the observations
  std::size_t landmark = 0;                              ///< place in LandmarkIndex::landmarks()
  Eigen::Vector2d innovation = Eigen::Vector2d::Zero();  ///< z - h
  Eigen::Matrix<double, 2, 3> dobservation_dpose = Eigen::Matrix<double, 2, 3>::Zero();  ///< H
  /// Of observation and landmark: Q + H_p M H_p^T.
  Eigen::Matrix2d noise = Eigen::Matrix2d::Zero();
  double distance = 0.0;  ///< squared Mahalanobis distance, 2 degrees of freedom
};

struct Association {
  std::vector<LandmarkPair> pairs;           ///< at most one of each observation and landmark
  std::vector<ObservationVerdict> verdicts;  ///< one per observation
  bool proven = true;                        ///< the search was not cut short by max_nodes
};

/// All pairs that pass their own gate, by observation. Verdicts are kUsed where there is any.
Association gate_pairs(const PoseEstimate& map_T_base, const Pose2& base_T_laser,
                       const LandmarkIndex& map,
                       const std::vector<LandmarkObservation>& observations,
                       const AssociationParams& params);

/// Joint compatibility, \cite neira2001: of all sets of pairs that pass the joint gate the largest,
/// of these the one with the least joint distance; without the pairs that a rival does not have.
Association associate(const PoseEstimate& map_T_base, const Pose2& base_T_laser,
                      const LandmarkIndex& map,
                      const std::vector<LandmarkObservation>& observations,
                      const AssociationParams& params);

}  // namespace falko_slam
