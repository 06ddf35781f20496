// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/descriptor_curve.hpp"
#include "falko_slam/evaluation/repeatability_study.hpp"
#include "falko_slam/features/beta_grid.hpp"
#include "falko_slam/features/descriptors.hpp"

namespace falko_slam {

/// A keypoint with all descriptors that are compared.
struct ComparedFeature {
  Keypoint keypoint;
  Bsc bsc;
  Cgh cgh;
  BetaGrid beta_grid;
};
using FeatureFunction = std::function<std::vector<ComparedFeature>(const LaserScan&)>;

/// One of the descriptors of a feature.
struct NamedDescriptor {
  std::string name;
  std::function<double(const ComparedFeature&, const ComparedFeature&)> distance;
};
/// "BSC", "CGH" and "beta-grid".
const std::vector<NamedDescriptor>& compared_descriptors();

struct DescriptorCurve {
  std::string descriptor;
  std::vector<PrecisionRecall> points;
};

/// The curves of Fig. 3.9 of \cite kallasi2017 for one condition, one for each descriptor.
struct DescriptorCurves {
  std::string condition;
  std::vector<DescriptorCurve> curves;
};

struct DescriptorStudyParams {
  double min_overlap = 0.5;  ///< of the scan pairs of the viewpoint curve
  double max_overlap = 0.9;
  std::size_t curve_points = 50;
};

/// All descriptors of one scan against all of the other, over the cases of the repeatability study:
/// "viewpoint", "noise", "subsampling" and "oversampling" (over all levels). Two keypoints are the
/// same point if the greedy one-to-one association within its radius pairs them.
std::vector<DescriptorCurves> study_descriptors(const std::vector<PosedScan>& scans,
                                                const RepeatabilityCases& cases,
                                                const RepeatabilityParams& conditions,
                                                const DescriptorStudyParams& params,
                                                const FeatureFunction& extract);

}  // namespace falko_slam
