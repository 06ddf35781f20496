// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/repeatability_study.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "falko_slam/evaluation/point_association.hpp"
#include "falko_slam/evaluation/scan_overlap.hpp"
#include "falko_slam/evaluation/scan_perturbation.hpp"

namespace falko_slam {
namespace {

// Compares one reference scan with changed copies of itself.
class SelfComparison {
 public:
  SelfComparison(const LaserScan& reference, const KeypointFunction& detect, double radius)
      : reference_(reference),
        detect_(detect),
        radius_(radius),
        points_(positions(detect(reference))) {}

  bool empty() const { return points_.empty(); }

  void add(const LaserScan& changed, MeanValue& result) const {
    result.add(repeatability(points_, positions(detect_(changed)), radius_));
  }
  const LaserScan& reference() const { return reference_; }

 private:
  const LaserScan& reference_;
  const KeypointFunction& detect_;
  double radius_;
  std::vector<Eigen::Vector2d> points_;
};

void study_viewpoints(const std::vector<PosedScan>& scans, const RepeatabilityCases& cases,
                      const RepeatabilityParams& params, const KeypointFunction& detect,
                      RepeatabilityResult& result) {
  std::vector<std::vector<Eigen::Vector2d>> in_map;
  in_map.reserve(scans.size());
  for (const PosedScan& posed : scans) {
    in_map.push_back(positions(detect(posed.scan), posed.map_T_laser));
  }
  for (const ViewpointPair& pair : cases.viewpoints) {
    if (in_map[pair.reference].empty()) continue;
    const auto bin =
        static_cast<std::size_t>(pair.overlap * static_cast<double>(params.overlap_bins));
    result.viewpoint[std::min(bin, params.overlap_bins - 1)].add(
        repeatability(in_map[pair.reference], in_map[pair.other], params.association_radius));
  }
}

}  // namespace

RepeatabilityCases choose_cases(const std::vector<PosedScan>& scans,
                                const RepeatabilityParams& params) {
  RepeatabilityCases cases;
  cases.references.resize(scans.size());
  std::iota(cases.references.begin(), cases.references.end(), std::size_t{0});
  std::mt19937_64 random(params.seed);
  std::shuffle(cases.references.begin(), cases.references.end(), random);
  cases.references.resize(std::min(scans.size(), params.reference_scans));
  for (const std::size_t i : cases.references) {
    for (std::size_t j = 0; j < scans.size(); ++j) {
      const Eigen::Vector2d apart =
          scans[i].map_T_laser.translation() - scans[j].map_T_laser.translation();
      if (j == i || apart.norm() >= params.viewpoint_distance) continue;
      cases.viewpoints.push_back({i, j, scan_overlap(scans[i], scans[j])});
    }
  }
  return cases;
}

RepeatabilityResult study_repeatability(const std::vector<PosedScan>& scans,
                                        const RepeatabilityCases& cases,
                                        const RepeatabilityParams& params,
                                        const KeypointFunction& detect) {
  RepeatabilityResult result;
  result.viewpoint.resize(params.overlap_bins);
  result.noise.resize(params.noise_levels.size());
  result.subsampling.resize(params.sampling_levels.size());
  result.oversampling.resize(params.sampling_levels.size());
  study_viewpoints(scans, cases, params, detect, result);

  std::mt19937_64 random(params.seed);
  for (const std::size_t i : cases.references) {
    const SelfComparison compare(scans[i].scan, detect, params.association_radius);
    // Drawn for every scan, so that each meets the same noise whatever the detector.
    for (std::size_t k = 0; k < params.noise_levels.size(); ++k) {
      const LaserScan noisy = with_noise(compare.reference(), params.noise_levels[k], random);
      if (!compare.empty()) compare.add(noisy, result.noise[k]);
    }
    if (compare.empty()) continue;
    for (std::size_t k = 0; k < params.sampling_levels.size(); ++k) {
      compare.add(subsampled(compare.reference(), params.sampling_levels[k]),
                  result.subsampling[k]);
      compare.add(oversampled(compare.reference(), params.sampling_levels[k]),
                  result.oversampling[k]);
    }
    for (const double angle : params.start_angles) {
      const auto turned = positions(detect(with_start_angle_turned(compare.reference(), angle)),
                                    Pose2(0.0, 0.0, -angle));
      const auto reference = positions(detect(compare.reference()));
      result.start_angle.add(repeatability(reference, turned, params.association_radius));
    }
  }
  return result;
}

}  // namespace falko_slam
