// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/descriptor_study.hpp"
#include "falko_slam/evaluation/keypoint_map.hpp"
#include "falko_slam/evaluation/repeatability_study.hpp"

namespace falko_slam {

struct FeatureEvaluationParams {
  RepeatabilityParams repeatability;
  DescriptorStudyParams descriptors;
  std::vector<double> map_radii = {0.05, 0.10};  ///< d_max of Table 3.1 [m]
  double map_separation = 0.20;                  ///< d_min of Table 3.1 [m]
  std::size_t map_orders = 10;  ///< random orders that the map statistics are averaged over
};

/// Wall time on this machine, in this run [us].
struct Timing {
  double mean = 0.0;
  double median = 0.0;
};

struct DetectorEvaluation {
  std::string name;
  double keypoints_per_scan = 0.0;
  Timing time;                                      ///< per scan
  std::vector<KeypointMapStatistics> map;           ///< by map radius, scans in the log's order
  std::vector<KeypointMapStatistics> map_shuffled;  ///< by map radius, mean over random orders
  RepeatabilityResult repeatability;
};

struct DescriptorEvaluation {
  std::string detector;                      ///< whose keypoints are described
  std::vector<DescriptorCurves> conditions;  ///< viewpoint, noise, subsampling, oversampling
  Timing bsc_and_cgh;                        ///< of all keypoints of a scan, from one pass
  Timing beta_grid;                          ///< of all keypoints of a scan
};

struct FeatureEvaluation {
  std::size_t scans = 0;
  std::size_t viewpoint_pairs = 0;
  /// FALKO, FALKO read literally, OC, FLIRT on curvature, FLIRT on ranges.
  std::vector<DetectorEvaluation> detectors;
  std::vector<DescriptorEvaluation> descriptors;  ///< of FALKO and of FLIRT curvature keypoints
};

/// Tables 3.1 and 3.2 and Figs. 3.8 and 3.9 of \cite kallasi2017 for one log, all with the default
/// parameters of the detectors. `tell` is called with what is being worked on.
FeatureEvaluation evaluate_features(const std::vector<PosedScan>& scans,
                                    const FeatureEvaluationParams& params,
                                    const std::function<void(const std::string&)>& tell);

}  // namespace falko_slam
