// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is done with every scan message: normaliser, de-skewing, all detectors and descriptors.
#include "falko_slam/features/face_detector.hpp"
#include "falko_slam/features/feature_extractor.hpp"
#include "falko_slam/features/flirt.hpp"
#include "falko_slam/features/orthogonal_corner.hpp"
#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/sensor/deskew.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/input_scan.hpp"

namespace falko_slam {
namespace fuzz {
namespace {

ScanNormalizerParams any_params(InputNumbers& numbers) {
  ScanNormalizerParams params;
  params.stamp_at = static_cast<ScanNormalizerParams::StampAt>(numbers.below(3));
  params.upside_down = numbers.any<std::uint8_t>() > 127;
  params.zero_is_no_return = numbers.any<std::uint8_t>() > 127;
  params.range_offset = numbers.within(1.0);
  return params;
}

void detect_all(const LaserScan& scan) {
  std::vector<Keypoint> keypoints;
  OrthogonalCornerDetector().detect(scan, keypoints);
  FlirtDetector().detect(scan, keypoints);
  std::vector<DetectedReflector> reflectors;
  ReflectorDetector().detect(scan, reflectors);
  for (const DetectedReflector& reflector : reflectors) {
    require(reflector.center.allFinite() && reflector.covariance.allFinite(),
            "reflectors are finite");
  }
  for (const DetectedFace& face : detect_faces(scan, {})) {
    require(face.middle.allFinite() && face.covariance.allFinite(), "faces are finite");
  }
}

}  // namespace

void fuzz_scan(const std::string& input) {
  InputNumbers numbers(input);
  FeatureExtractorParams params;
  params.scan = any_params(numbers);
  const LaserMotion motion{{numbers.within(1.0), numbers.within(1.0), numbers.within(1.0)},
                           from_seconds(0.125)};
  const InputScan scan = any_scan(numbers, 400);
  FeatureExtractor extractor(params);
  describe(extractor.extract(scan.raw()));
  for (const DescribedKeypoint& feature : extractor.features()) {
    require(feature.keypoint.position.allFinite(), "keypoints are finite");
  }
  detect_all(extractor.scan());
  detect_all(deskew(extractor.scan(), motion, extractor.scan().first_beam_time));
}

}  // namespace fuzz
}  // namespace falko_slam
