// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace falko_slam {

/// Distances between the descriptors of two scans, and which of the pairs are the same point.
struct DescriptorPair {
  double distance;
  bool same_point;
};

struct PrecisionRecall {
  double threshold;
  double precision;
  double recall;
};

/// Precision and recall of "the descriptors are nearer than a threshold", for thresholds spread
/// over all distances (\cite kallasi2017, Fig. 3.9): at most `points` of them, in ascending order.
/// Recall counts against all pairs that are the same point. Empty without any such pair.
std::vector<PrecisionRecall> precision_recall_curve(std::vector<DescriptorPair> pairs,
                                                    std::size_t points);

/// Greatest recall with a share of false matches (1-precision) of at most `max_false_share`.
double recall_at(const std::vector<PrecisionRecall>& curve, double max_false_share);

}  // namespace falko_slam
