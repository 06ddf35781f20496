// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/features/hough_spectrum.hpp"
#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/features/neighborhood_params.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct OrthogonalCornerParams {
  NeighborhoodParams neighborhood;
  HoughSpectrumParams spectrum;
  /// Both legs of a corner must be at least radius / leg_ratio long. [1, 20]
  double leg_ratio = 4.0;
  /// Residual of the legs about the dominant directions over the height of the corner: corners of
  /// other angles and in other directions exceed it. [0.01, 2]
  double max_roughness = 0.3;
  /// As in FalkoParams. [m]
  double suppression_radius = 0.20;
  double refinement_limit = 0.20;
  double merge_radius = 0.10;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const OrthogonalCornerParams& params);

/// OC: corners whose two sides run along the two dominant, orthogonal directions of the scan.
///
/// The detector that the thesis compares FALKO with (\cite kallasi2016). The dominant directions
/// come from the Hough spectrum. A beam is a corner if the points to its left lie along one of them
/// and those to its right along the other; its position is where the two legs, each fitted with its
/// direction held, meet; its orientation is their bisector (\cite kallasi2017 3.2.3). Suppression
/// and merging are those of FALKO; `Keypoint::score` is the squared roughness.
///
/// Does not depend on how the scan is turned, as long as the dominant directions are the same.
/// Not thread-safe; keeps its memory between scans.
class OrthogonalCornerDetector {
 public:
  explicit OrthogonalCornerDetector(const OrthogonalCornerParams& params = {});
  ~OrthogonalCornerDetector();
  OrthogonalCornerDetector(OrthogonalCornerDetector&&) noexcept;
  OrthogonalCornerDetector& operator=(OrthogonalCornerDetector&&) noexcept;

  /// Replaces `keypoints` by those of the scan, in the order of their beams.
  void detect(const LaserScan& scan, std::vector<Keypoint>& keypoints);
  std::vector<Keypoint> detect(const LaserScan& scan);

  const OrthogonalCornerParams& params() const { return params_; }

 private:
  struct Workspace;
  OrthogonalCornerParams params_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace falko_slam
