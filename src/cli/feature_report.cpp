// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "feature_report.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace falko_slam {

// What nlohmann::json calls, found beside the types.

static void to_json(nlohmann::json& json, const KeypointMapStatistics& row) {
  json = {{"landmarks", row.landmarks},
          {"mean_deviation", row.mean_deviation},
          {"max_deviation", row.max_deviation},
          {"single_share", row.single_share}};
}

static void to_json(nlohmann::json& json, const MeanValue& value) {
  json = {{"mean", value.mean}, {"count", value.count}};
}

static void to_json(nlohmann::json& json, const Timing& time) {
  json = {{"mean_us", time.mean}, {"median_us", time.median}};
}

static void to_json(nlohmann::json& json, const PrecisionRecall& point) {
  json = {{"threshold", point.threshold}, {"precision", point.precision}, {"recall", point.recall}};
}

static void to_json(nlohmann::json& json, const RepeatabilityResult& result) {
  json = {{"viewpoint", result.viewpoint},
          {"noise", result.noise},
          {"subsampling", result.subsampling},
          {"oversampling", result.oversampling},
          {"start_angle", result.start_angle}};
}

static void to_json(nlohmann::json& json, const DetectorEvaluation& detector) {
  json = {{"name", detector.name},
          {"keypoints_per_scan", detector.keypoints_per_scan},
          {"time", detector.time},
          {"map", detector.map},
          {"map_shuffled", detector.map_shuffled},
          {"repeatability", detector.repeatability}};
}

static void to_json(nlohmann::json& json, const DescriptorCurve& curve) {
  json = {{"descriptor", curve.descriptor}, {"points", curve.points}};
}

static void to_json(nlohmann::json& json, const DescriptorCurves& curves) {
  json = {{"condition", curves.condition}, {"curves", curves.curves}};
}

static void to_json(nlohmann::json& json, const DescriptorEvaluation& evaluation) {
  json = {{"detector", evaluation.detector},
          {"conditions", evaluation.conditions},
          {"bsc_and_cgh_time", evaluation.bsc_and_cgh},
          {"beta_grid_time", evaluation.beta_grid}};
}

namespace cli {
namespace {

void print_map_table(const FeatureEvaluation& evaluation, const FeatureEvaluationParams& params) {
  std::printf(
      "\nStability in the map (Table 3.1): landmarks, mean deviations [m], single points\n");
  for (std::size_t i = 0; i < params.map_radii.size(); ++i) {
    std::printf(
        "  d_max %.2f m            log order                     mean of %zu random orders\n",
        params.map_radii[i], params.map_orders);
    for (const DetectorEvaluation& detector : evaluation.detectors) {
      std::printf("  %-16s", detector.name.c_str());
      for (const KeypointMapStatistics* row : {&detector.map[i], &detector.map_shuffled[i]}) {
        std::printf("  %6.0f  %.4f  %.4f  %4.1f %%", row->landmarks, row->mean_deviation,
                    row->max_deviation, 100.0 * row->single_share);
      }
      std::printf("\n");
    }
  }
}

void print_values(const std::string& name, const std::vector<MeanValue>& values) {
  std::printf("  %-16s", name.c_str());
  for (const MeanValue& value : values) {
    if (value.count == 0) {
      std::printf("      -");
    } else {
      std::printf("  %5.3f", value.mean);
    }
  }
  std::printf("\n");
}

// One of the tests of Fig. 3.8, a row for each detector.
void print_repeatability(const FeatureEvaluation& evaluation, const std::string& title,
                         const std::vector<MeanValue> RepeatabilityResult::*values) {
  std::printf("%s\n", title.c_str());
  for (const DetectorEvaluation& detector : evaluation.detectors) {
    print_values(detector.name, detector.repeatability.*values);
  }
}

template <class Level>
std::string titled(const char* title, const char* format, const std::vector<Level>& levels) {
  char text[32];
  std::snprintf(text, sizeof text, "  %-16s", title);
  std::string line = text;
  for (const Level level : levels) {
    std::snprintf(text, sizeof text, format, level);
    line += text;
  }
  return line;
}

std::vector<double> bin_starts(std::size_t bins) {
  std::vector<double> starts;
  for (std::size_t i = 0; i < bins; ++i) {
    starts.push_back(static_cast<double>(i) / static_cast<double>(bins));
  }
  return starts;
}

void print_repeatabilities(const FeatureEvaluation& evaluation, const RepeatabilityParams& params) {
  std::printf("\nRepeatability (Fig. 3.8): keypoints found again within %.2f m\n",
              params.association_radius);
  print_repeatability(evaluation,
                      titled("overlap from", "  %5.2f", bin_starts(params.overlap_bins)),
                      &RepeatabilityResult::viewpoint);
  print_repeatability(evaluation, titled("noise [m]", "  %5.2f", params.noise_levels),
                      &RepeatabilityResult::noise);
  print_repeatability(evaluation, titled("beams removed", "  %5zu", params.sampling_levels),
                      &RepeatabilityResult::subsampling);
  print_repeatability(evaluation, titled("beams added", "  %5zu", params.sampling_levels),
                      &RepeatabilityResult::oversampling);
  std::printf("  start angle turned\n");
  for (const DetectorEvaluation& detector : evaluation.detectors) {
    print_values(detector.name, {detector.repeatability.start_angle});
  }
}

void print_descriptors(const DescriptorEvaluation& evaluation) {
  constexpr double kShares[] = {0.1, 0.2, 0.3, 0.5};
  std::printf("\nDescriptors of %s keypoints (Fig. 3.9): recall at 1-precision of at most\n",
              evaluation.detector.c_str());
  std::printf("  %-22s", "");
  for (const double share : kShares) std::printf("   %.1f", share);
  std::printf("\n");
  for (const DescriptorCurves& curves : evaluation.conditions) {
    for (const DescriptorCurve& curve : curves.curves) {
      std::printf("  %-12s %-9s", curves.condition.c_str(), curve.descriptor.c_str());
      for (const double share : kShares) std::printf("  %.2f", recall_at(curve.points, share));
      std::printf("\n");
    }
  }
}

}  // namespace

void print_report(const FeatureEvaluation& evaluation, const FeatureEvaluationParams& params) {
  std::printf("%zu scans, %zu reference scans, %zu pairs of scans within %.1f m\n",
              evaluation.scans, std::min(evaluation.scans, params.repeatability.reference_scans),
              evaluation.viewpoint_pairs, params.repeatability.viewpoint_distance);
  print_map_table(evaluation, params);
  print_repeatabilities(evaluation, params.repeatability);
  for (const DescriptorEvaluation& descriptors : evaluation.descriptors) {
    print_descriptors(descriptors);
  }
  std::printf(
      "\nTime per scan on this machine (Table 3.2) [us]: mean, median; keypoints per scan\n");
  for (const DetectorEvaluation& detector : evaluation.detectors) {
    std::printf("  %-16s  %8.1f  %8.1f  %6.2f\n", detector.name.c_str(), detector.time.mean,
                detector.time.median, detector.keypoints_per_scan);
  }
  for (const DescriptorEvaluation& descriptors : evaluation.descriptors) {
    std::printf("  of the keypoints of %s\n", descriptors.detector.c_str());
    std::printf("  %-16s  %8.1f  %8.1f\n", "BSC and CGH", descriptors.bsc_and_cgh.mean,
                descriptors.bsc_and_cgh.median);
    std::printf("  %-16s  %8.1f  %8.1f\n", "beta-grid", descriptors.beta_grid.mean,
                descriptors.beta_grid.median);
  }
}

nlohmann::json as_json(const FeatureEvaluation& evaluation, const FeatureEvaluationParams& params) {
  const RepeatabilityParams& conditions = params.repeatability;
  return {{"scans", evaluation.scans},
          {"viewpoint_pairs", evaluation.viewpoint_pairs},
          {"conditions",
           {{"reference_scans", conditions.reference_scans},
            {"seed", conditions.seed},
            {"association_radius", conditions.association_radius},
            {"viewpoint_distance", conditions.viewpoint_distance},
            {"overlap_bins", conditions.overlap_bins},
            {"noise_levels", conditions.noise_levels},
            {"sampling_levels", conditions.sampling_levels},
            {"start_angles", conditions.start_angles},
            {"map_radii", params.map_radii},
            {"map_separation", params.map_separation},
            {"map_orders", params.map_orders}}},
          {"detectors", evaluation.detectors},
          {"descriptors", evaluation.descriptors}};
}

}  // namespace cli
}  // namespace falko_slam
