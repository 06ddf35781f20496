// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/feature_extractor.hpp"

namespace falko_slam {

FeatureExtractor::FeatureExtractor(const FeatureExtractorParams& params)
    : params_(params), detector_(params.falko), descriptors_(params.descriptor) {
  validate(params_.scan);
}

ScanReport FeatureExtractor::extract(const RawScan& raw) {
  const ScanReport report = normalize(raw, params_.scan, scan_);
  detector_.detect(scan_, keypoints_);
  descriptors_.extract(scan_, keypoints_, features_);
  return report;
}

}  // namespace falko_slam
