// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/descriptor_curve.hpp"

#include <algorithm>

namespace falko_slam {

std::vector<PrecisionRecall> precision_recall_curve(std::vector<DescriptorPair> pairs,
                                                    std::size_t points) {
  const auto same = std::count_if(pairs.begin(), pairs.end(),
                                  [](const DescriptorPair& pair) { return pair.same_point; });
  std::vector<PrecisionRecall> curve;
  if (same == 0 || points == 0) return curve;
  std::sort(pairs.begin(), pairs.end(), [](const DescriptorPair& a, const DescriptorPair& b) {
    return a.distance < b.distance;
  });
  // A point of the curve each time another 1 / points of the same-point pairs has been found.
  double matched = 0.0;
  double correct = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    matched += 1.0;
    correct += pairs[i].same_point ? 1.0 : 0.0;
    const bool last_of_distance =
        i + 1 == pairs.size() || pairs[i + 1].distance > pairs[i].distance;
    const double recall = correct / static_cast<double>(same);
    const double next = static_cast<double>(curve.size() + 1) / static_cast<double>(points);
    if (!last_of_distance || recall < next) continue;
    curve.push_back({pairs[i].distance, correct / matched, recall});
    if (recall >= 1.0) break;
  }
  return curve;
}

double recall_at(const std::vector<PrecisionRecall>& curve, double max_false_share) {
  double best = 0.0;
  for (const PrecisionRecall& point : curve) {
    if (1.0 - point.precision <= max_false_share) best = std::max(best, point.recall);
  }
  return best;
}

}  // namespace falko_slam
