// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "falko_slam/localization/association.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// The motion of a tricycle's base_link in its own frame by (5.8), with the noise of its mean
/// steering.
PoseEstimate tricycle_motion(const TricycleParams& tricycle, double ticks,
                             const SteeringSweep& steering, const OdometryNoise& noise);

/// A correction and how well the pairs fitted.
struct PoseCorrection {
  PoseEstimate map_T_base;
  double nis = 0.0;  ///< normalised innovation squared of all pairs together, 2 degrees each
};

/// (5.5) to (5.7) with all pairs at once: those of `pairs` that were predicted from `map_T_base`.
///
/// Worked off one by one, each from the same point of linearisation, which comes to the same and
/// inverts 2x2 matrices only. Deviation: (5.7) in Joseph's form, (I - K H) P (I - K H)^T + K N K^T,
/// so that rounding leaves the covariance symmetric and positive definite.
PoseCorrection correct(const PoseEstimate& map_T_base, const std::vector<LandmarkPair>& pairs);

struct PoseFilterParams {
  Pose2 base_T_laser;
  AssociationParams association;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const PoseFilterParams& params);

/// What an update did.
struct PoseUpdate {
  Association association;
  double nis = 0.0;            ///< of the pairs that were used
  int degrees_of_freedom = 0;  ///< of it: two each

  bool corrected() const { return degrees_of_freedom > 0; }
};

/// Extended Kalman filter for the pose of base_link on a fixed map of landmarks, \cite kallasi2017
/// 5.3: (5.1) to (5.16) with the pose of the laser in the measurement model.
///
/// The covariance is that of the additive error of (x, y, theta), x and y along the axes of map:
/// PoseEstimate's. The covariances of landmarks enter the innovation as if they were drawn anew for
/// every observation: a map error that stays makes the filter too sure the longer it looks.
///
/// Nothing that is not finite gets in: such motions and observations are refused. Not thread-safe.
class PoseFilter {
 public:
  /// Throws std::invalid_argument for params, no map, or a pose or covariance that is none.
  PoseFilter(const PoseFilterParams& params, std::shared_ptr<const LandmarkIndex> map,
             const PoseEstimate& map_T_base);

  /// (5.3), (5.4) by the motion of base_link since the last one, in its own frame. False if it was
  /// refused: not finite, or a covariance that is not positive semidefinite.
  bool predict(const PoseEstimate& motion);

  PoseUpdate update(const std::vector<LandmarkObservation>& observations);

  const PoseEstimate& map_T_base() const { return map_T_base_; }
  /// The pose is taken as it is. Throws std::invalid_argument as the constructor does.
  void reset(const PoseEstimate& map_T_base);

 private:
  PoseFilterParams params_;
  std::shared_ptr<const LandmarkIndex> map_;
  PoseEstimate map_T_base_;
};

}  // namespace falko_slam
