// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/features/descriptor_extractor.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

struct FeatureExtractorParams {
  ScanNormalizerParams scan;
  FalkoParams falko;
  DescriptorParams descriptor;
};

/// From a scan as it comes to its features: normalise, detect, describe.
/// Keeps its memory between scans; not thread-safe.
class FeatureExtractor {
 public:
  /// Throws std::invalid_argument with the field and its value.
  explicit FeatureExtractor(const FeatureExtractorParams& params = {});

  /// What became of the scan. `scan()` and `features()` are those of this call; without an usable
  /// scan both are empty.
  ScanReport extract(const RawScan& raw);

  const LaserScan& scan() const { return scan_; }
  const std::vector<DescribedKeypoint>& features() const { return features_; }
  const FeatureExtractorParams& params() const { return params_; }

 private:
  FeatureExtractorParams params_;
  FalkoDetector detector_;
  DescriptorExtractor descriptors_;
  LaserScan scan_;
  std::vector<Keypoint> keypoints_;
  std::vector<DescribedKeypoint> features_;
};

}  // namespace falko_slam
