// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct FeatureMapperParams {
  /// Keypoints within this of a cluster's middle belong to it. Greater: corners that stand close
  /// become one. [0.005, 1] [m]
  double cluster_radius = 0.06;
  /// Scans that must have a keypoint in a cluster. [1, 1000000]
  int min_hits = 10;
  /// Places from which it must have been seen: a hundred scans from one are one view. [1, 100000]
  int min_viewpoints = 4;
  /// Scans taken within this of each other are of one viewpoint. [0.01, 100] [m]
  double viewpoint_spacing = 0.3;
  /// Hits over the scans that should have seen it. Greater: less that moves or is seen now and then
  /// gets in. [0, 1]
  double min_share = 0.4;
  /// Of two landmarks nearer than this only the one that more viewpoints saw stays, and none this
  /// near to a reflector. [0, 10] [m]
  double separation = 0.15;
  /// Standard deviation of a corner's place between viewpoints, where only a few tell it; counts as
  /// much as two of them. [0.0001, 1] [m]
  double usual_deviation = 0.01;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const FeatureMapperParams& params);

/// What became of the clusters of a map.
struct FeatureMapReport {
  std::size_t scans = 0;
  std::size_t viewpoints = 0;
  std::size_t keypoints = 0;
  std::size_t clusters = 0;               ///< of any size
  std::size_t too_few_hits = 0;           ///< or viewpoints
  std::size_t too_small_share = 0;        ///< moved away, or seen now and then only
  std::size_t too_near = 0;               ///< to a better one, or to a reflector
  std::size_t features = 0;               ///< in the map
  std::size_t keypoints_of_features = 0;  ///< in the clusters of these
};

struct FeatureMap {
  LandmarkMap map;
  FeatureMapReport report;
};

/// A fixed map of corners from scans with known poses (\cite kallasi2017 5.6, Fig. 5.7): keypoints
/// are clustered by place, and the middle of each cluster that enough scans saw is a landmark.
///
/// A corner's errors are nearly the same in all scans from one place and change with the viewpoint.
/// So scans are grouped by the place they were taken from; the landmark is the mean over viewpoints
/// of their mean keypoints, each weighted by the noise of a single one, and its covariance is their
/// scatter about it, not divided by their number: as far off another viewpoint will see it.
///
/// A scan should have seen a landmark if it looks through the place where it should be, or shows a
/// surface there and was taken from a viewpoint that saw the landmark at another time. What stood
/// for a while only is left out by that.
///
/// The same scans give the same map, to the last bit. O(n log n) in keypoints, and scans times
/// clusters; holds the ranges of all scans, four bytes a beam. Not thread-safe.
class FeatureMapper {
 public:
  /// Throws std::invalid_argument with the field and its value.
  explicit FeatureMapper(const FeatureMapperParams& params = {});
  ~FeatureMapper();
  FeatureMapper(FeatureMapper&&) noexcept;
  FeatureMapper& operator=(FeatureMapper&&) noexcept;

  /// A scan freed of the motion, and its keypoints in the frame of the laser; those that are not
  /// finite or have no covariance are left out.
  void add(const Pose2& map_T_laser, const LaserScan& scan,
           const std::vector<PointEstimate>& keypoints);

  /// The landmarks of `known`, and behind them the features by x, then y, with the ids after the
  /// greatest known one.
  FeatureMap build(const LandmarkMap& known = {}) const;

 private:
  struct Scans;
  FeatureMapperParams params_;
  std::unique_ptr<Scans> scans_;
};

}  // namespace falko_slam
