// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/feature_evaluation.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "falko_slam/evaluation/literal_falko.hpp"
#include "falko_slam/evaluation/point_association.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/orthogonal_corner.hpp"

namespace falko_slam {
namespace {

struct NamedDetector {
  std::string name;
  KeypointFunction detect;
};

Timing summarize(std::vector<double> microseconds) {
  if (microseconds.empty()) return {};
  const auto middle = microseconds.begin() + static_cast<std::ptrdiff_t>(microseconds.size() / 2);
  std::nth_element(microseconds.begin(), middle, microseconds.end());
  const double sum = std::accumulate(microseconds.begin(), microseconds.end(), 0.0);
  return {sum / static_cast<double>(microseconds.size()), *middle};
}

template <class Work>
double microseconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
      .count();
}

DetectorEvaluation evaluate(const NamedDetector& detector, const std::vector<PosedScan>& scans,
                            const RepeatabilityCases& cases,
                            const FeatureEvaluationParams& params) {
  DetectorEvaluation result;
  result.name = detector.name;
  std::vector<std::vector<Eigen::Vector2d>> in_map;
  std::vector<double> times;
  for (const PosedScan& posed : scans) {
    std::vector<Keypoint> keypoints;
    times.push_back(microseconds_of([&] { keypoints = detector.detect(posed.scan); }));
    result.keypoints_per_scan +=
        static_cast<double>(keypoints.size()) / static_cast<double>(scans.size());
    in_map.push_back(positions(keypoints, posed.map_T_laser));
  }
  result.time = summarize(std::move(times));
  for (const double radius : params.map_radii) {
    const KeypointMapParams map{radius, params.map_separation};
    result.map.push_back(keypoint_map_statistics(in_map, map));
    result.map_shuffled.push_back(shuffled_keypoint_map_statistics(in_map, map, params.map_orders,
                                                                   params.repeatability.seed));
  }
  result.repeatability = study_repeatability(scans, cases, params.repeatability, detector.detect);
  return result;
}

void evaluate_descriptors(const std::vector<PosedScan>& scans, const RepeatabilityCases& cases,
                          const FeatureEvaluationParams& params, FeatureEvaluation& result) {
  FalkoDetector detector;
  DescriptorExtractor extractor;
  std::vector<double> times;
  std::vector<DescribedKeypoint> features;
  for (const PosedScan& posed : scans) {
    const std::vector<Keypoint> keypoints = detector.detect(posed.scan);
    times.push_back(microseconds_of([&] { extractor.extract(posed.scan, keypoints, features); }));
  }
  result.descriptor_time = summarize(std::move(times));
  result.descriptors = study_descriptors(
      scans, cases, params.repeatability, params.descriptors,
      [&](const LaserScan& scan) { return extractor.extract(scan, detector.detect(scan)); });
}

}  // namespace

FeatureEvaluation evaluate_features(const std::vector<PosedScan>& scans,
                                    const FeatureEvaluationParams& params,
                                    const std::function<void(const std::string&)>& tell) {
  FeatureEvaluation result;
  tell("overlap of scan pairs");
  const RepeatabilityCases cases = choose_cases(scans, params.repeatability);
  result.scans = scans.size();
  result.viewpoint_pairs = cases.viewpoints.size();

  FalkoDetector falko;
  OrthogonalCornerDetector orthogonal;
  const std::vector<NamedDetector> detectors = {
      {"FALKO", [&](const LaserScan& scan) { return falko.detect(scan); }},
      {"FALKO, literal", [](const LaserScan& scan) { return literal_falko(scan); }},
      {"OC", [&](const LaserScan& scan) { return orthogonal.detect(scan); }}};
  for (const NamedDetector& detector : detectors) {
    tell(detector.name);
    result.detectors.push_back(evaluate(detector, scans, cases, params));
  }
  tell("descriptors");
  evaluate_descriptors(scans, cases, params, result);
  return result;
}

}  // namespace falko_slam
