// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/localization/pose_filter.hpp"

namespace falko_slam {

struct ExternalMapParams {
  PoseFilterParams filter;
  /// u_r: share by which a landmark moves to where it was seen. [0, 1]
  double update_rate = 0.1;
  /// Landmarks at a time; beyond, nothing is added. [1, 10000]
  int max_landmarks = 60;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ExternalMapParams& params);

/// A landmark of the external map.
struct ExternalLandmark {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< in map [m]
  int hits = 0;                                        ///< falls while it is not seen
};

/// Localization on a fixed map and an external dynamic map (\cite kallasi2017, 5.4.1, Algorithm 1).
/// For comparison: landmarks are put where the pose of the moment says and are then believed, so
/// the covariance of the pose knows nothing of their errors and it drifts while it seems sure.
/// LandmarkFilter keeps them in the state. Not thread-safe.
class ExternalMapFilter {
 public:
  /// Throws std::invalid_argument for params, or a pose or covariance that is none. `map` may be
  /// null.
  ExternalMapFilter(const ExternalMapParams& params,
                    const std::shared_ptr<const LandmarkIndex>& map,
                    const PoseEstimate& map_T_base);

  /// As PoseFilter::predict().
  bool predict(const PoseEstimate& motion);

  /// Corrects the pose with both maps, then updates the external one. Only observations of natural
  /// features get into it.
  PoseUpdate update(const std::vector<LandmarkObservation>& observations);

  const PoseEstimate& map_T_base() const { return map_T_base_; }
  const std::vector<ExternalLandmark>& landmarks() const { return landmarks_; }

 private:
  std::shared_ptr<const LandmarkIndex> both_maps() const;
  void update_map(const std::vector<LandmarkObservation>& observations, const PoseUpdate& update);

  ExternalMapParams params_;
  std::vector<Landmark> fixed_;
  PoseEstimate map_T_base_;
  std::vector<ExternalLandmark> landmarks_;
};

}  // namespace falko_slam
