// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/feature_evaluation.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "falko_slam/evaluation/literal_falko.hpp"
#include "falko_slam/evaluation/point_association.hpp"
#include "falko_slam/features/beta_grid.hpp"
#include "falko_slam/features/descriptor_extractor.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/flirt.hpp"
#include "falko_slam/features/orthogonal_corner.hpp"

namespace falko_slam {
namespace {

// Places in the list of the detectors.
constexpr std::size_t kFalko = 0;
constexpr std::size_t kFlirtCurvature = 3;

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

// Describes the keypoints of a scan in all ways.
class FeatureComparison {
 public:
  explicit FeatureComparison(KeypointFunction detect) : detect_(std::move(detect)) {}

  std::vector<ComparedFeature> operator()(const LaserScan& scan) {
    const std::vector<Keypoint> keypoints = detect_(scan);
    bsc_and_cgh_times_.push_back(
        microseconds_of([&] { descriptors_.extract(scan, keypoints, described_); }));
    beta_grid_times_.push_back(
        microseconds_of([&] { beta_grids_.extract(scan, keypoints, grids_); }));
    std::vector<ComparedFeature> features;
    for (std::size_t i = 0; i < keypoints.size(); ++i) {
      features.push_back({keypoints[i], described_[i].bsc, described_[i].cgh, grids_[i]});
    }
    return features;
  }

  Timing bsc_and_cgh_time() const { return summarize(bsc_and_cgh_times_); }
  Timing beta_grid_time() const { return summarize(beta_grid_times_); }

 private:
  KeypointFunction detect_;
  DescriptorExtractor descriptors_;
  BetaGridExtractor beta_grids_;
  std::vector<DescribedKeypoint> described_;
  std::vector<BetaGrid> grids_;
  std::vector<double> bsc_and_cgh_times_, beta_grid_times_;
};

DescriptorEvaluation evaluate_descriptors(const NamedDetector& detector,
                                          const std::vector<PosedScan>& scans,
                                          const RepeatabilityCases& cases,
                                          const FeatureEvaluationParams& params) {
  FeatureComparison timed(detector.detect);
  for (const PosedScan& posed : scans) timed(posed.scan);
  FeatureComparison compare(detector.detect);
  return {detector.name,
          study_descriptors(scans, cases, params.repeatability, params.descriptors,
                            [&](const LaserScan& scan) { return compare(scan); }),
          timed.bsc_and_cgh_time(), timed.beta_grid_time()};
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
  FlirtDetector curvature;
  FlirtDetector range(flirt_range_params());
  const std::vector<NamedDetector> detectors = {
      {"FALKO", [&](const LaserScan& scan) { return falko.detect(scan); }},
      {"FALKO, literal", [](const LaserScan& scan) { return literal_falko(scan); }},
      {"OC", [&](const LaserScan& scan) { return orthogonal.detect(scan); }},
      {"FLIRT curvature", [&](const LaserScan& scan) { return curvature.detect(scan); }},
      {"FLIRT range", [&](const LaserScan& scan) { return range.detect(scan); }}};
  for (const NamedDetector& detector : detectors) {
    tell(detector.name);
    result.detectors.push_back(evaluate(detector, scans, cases, params));
  }
  for (const std::size_t i : {kFalko, kFlirtCurvature}) {
    tell("descriptors of " + detectors[i].name + " keypoints");
    result.descriptors.push_back(evaluate_descriptors(detectors[i], scans, cases, params));
  }
  return result;
}

}  // namespace falko_slam
