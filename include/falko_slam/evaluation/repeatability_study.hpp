// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "falko_slam/evaluation/posed_scan.hpp"
#include "falko_slam/features/keypoint.hpp"

namespace falko_slam {

using KeypointFunction = std::function<std::vector<Keypoint>(const LaserScan&)>;

/// The conditions of Fig. 3.8 of \cite kallasi2017; what its text leaves open has its value here.
struct RepeatabilityParams {
  std::size_t reference_scans = 100;  ///< drawn at random, the same for every detector
  std::uint64_t seed = 1;
  double viewpoint_distance = 1.0;   ///< scans nearer than this are compared [m]
  double association_radius = 0.10;  ///< keypoints nearer than this are the same one [m]
  std::size_t overlap_bins = 10;     ///< over [0, 1]
  std::vector<double> noise_levels = {0.01, 0.02, 0.05, 0.10, 0.20, 0.30};  ///< [m]
  std::vector<std::size_t> sampling_levels = {1, 2, 3, 4};  ///< beams removed or added between two
  std::vector<double> start_angles = {0.01, 0.5, 1.0, 2.0, 3.0};  ///< [rad]
};

/// Two scans of one place.
struct ViewpointPair {
  std::size_t reference, other;
  double overlap;
};

/// The reference scans and what they are compared with: chosen once, for all detectors.
struct RepeatabilityCases {
  std::vector<std::size_t> references;
  std::vector<ViewpointPair> viewpoints;
};
RepeatabilityCases choose_cases(const std::vector<PosedScan>& scans,
                                const RepeatabilityParams& params);

/// A mean, and of how many.
struct MeanValue {
  double mean = 0.0;
  std::size_t count = 0;

  void add(double value) {
    ++count;
    mean += (value - mean) / static_cast<double>(count);
  }
};

/// Repeatability |common| / min(n, m); reference scans without keypoints are left out, other scans
/// without keypoints count 0.
struct RepeatabilityResult {
  std::vector<MeanValue> viewpoint;     ///< by overlap bin
  std::vector<MeanValue> noise;         ///< by noise level
  std::vector<MeanValue> subsampling;   ///< by sampling level
  std::vector<MeanValue> oversampling;  ///< by sampling level
  MeanValue start_angle;                ///< over all start angles
};
RepeatabilityResult study_repeatability(const std::vector<PosedScan>& scans,
                                        const RepeatabilityCases& cases,
                                        const RepeatabilityParams& params,
                                        const KeypointFunction& detect);

}  // namespace falko_slam
