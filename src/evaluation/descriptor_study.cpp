// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/descriptor_study.hpp"

#include <random>

#include "falko_slam/evaluation/point_association.hpp"
#include "falko_slam/evaluation/scan_perturbation.hpp"

namespace falko_slam {
namespace {

using Features = std::vector<ComparedFeature>;

std::vector<Eigen::Vector2d> positions_of(const Features& features, const Pose2& map_T_laser) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(features.size());
  for (const ComparedFeature& feature : features)
    points.push_back(map_T_laser * feature.keypoint.position);
  return points;
}

// The pairs of one condition, for each descriptor.
class PairCollection {
 public:
  explicit PairCollection(double association_radius)
      : association_radius_(association_radius), pairs_(compared_descriptors().size()) {}

  void add(const Features& a, const Pose2& map_T_a, const Features& b, const Pose2& map_T_b) {
    std::vector<std::vector<bool>> same(a.size(), std::vector<bool>(b.size()));
    for (const AssociatedPair& pair : associate_greedily(
             positions_of(a, map_T_a), positions_of(b, map_T_b), association_radius_)) {
      same[pair.first][pair.second] = true;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
          pairs_[k].push_back({compared_descriptors()[k].distance(a[i], b[j]), same[i][j]});
        }
      }
    }
  }

  DescriptorCurves curves(const std::string& condition, std::size_t points) const {
    DescriptorCurves curves{condition, {}};
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      curves.curves.push_back(
          {compared_descriptors()[k].name, precision_recall_curve(pairs_[k], points)});
    }
    return curves;
  }

 private:
  double association_radius_;
  std::vector<std::vector<DescriptorPair>> pairs_;  // by descriptor
};

}  // namespace

const std::vector<NamedDescriptor>& compared_descriptors() {
  using Feature = ComparedFeature;
  static const std::vector<NamedDescriptor> descriptors = {
      {"BSC", [](const Feature& a,
                 const Feature& b) { return static_cast<double>(distance(a.bsc, b.bsc)); }},
      {"CGH", [](const Feature& a, const Feature& b) { return distance(a.cgh, b.cgh); }},
      {"beta-grid",
       [](const Feature& a, const Feature& b) { return distance(a.beta_grid, b.beta_grid); }}};
  return descriptors;
}

std::vector<DescriptorCurves> study_descriptors(const std::vector<PosedScan>& scans,
                                                const RepeatabilityCases& cases,
                                                const RepeatabilityParams& conditions,
                                                const DescriptorStudyParams& params,
                                                const FeatureFunction& extract) {
  PairCollection viewpoint(conditions.association_radius);
  PairCollection noise(conditions.association_radius);
  PairCollection subsampling(conditions.association_radius);
  PairCollection oversampling(conditions.association_radius);
  for (const ViewpointPair& pair : cases.viewpoints) {
    if (pair.overlap < params.min_overlap || pair.overlap > params.max_overlap) continue;
    const PosedScan& a = scans[pair.reference];
    const PosedScan& b = scans[pair.other];
    viewpoint.add(extract(a.scan), a.map_T_laser, extract(b.scan), b.map_T_laser);
  }
  std::mt19937_64 random(conditions.seed);
  for (const std::size_t i : cases.references) {
    const LaserScan& scan = scans[i].scan;
    const Features reference = extract(scan);
    const auto add = [&](PairCollection& pairs, const LaserScan& changed) {
      pairs.add(reference, {}, extract(changed), {});
    };
    for (const double level : conditions.noise_levels) add(noise, with_noise(scan, level, random));
    for (const std::size_t level : conditions.sampling_levels) {
      add(subsampling, subsampled(scan, level));
      add(oversampling, oversampled(scan, level));
    }
  }
  return {viewpoint.curves("viewpoint", params.curve_points),
          noise.curves("noise", params.curve_points),
          subsampling.curves("subsampling", params.curve_points),
          oversampling.curves("oversampling", params.curve_points)};
}

}  // namespace falko_slam
