// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/feature_evaluation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/features/falko.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// All figures but the times, in the order of the structs.
std::vector<double> figures(const FeatureEvaluation& evaluation) {
  std::vector<double> all = {static_cast<double>(evaluation.scans),
                             static_cast<double>(evaluation.viewpoint_pairs)};
  const auto add_values = [&](const std::vector<MeanValue>& values) {
    for (const auto& value : values) {
      all.insert(all.end(), {value.mean, static_cast<double>(value.count)});
    }
  };
  for (const auto& detector : evaluation.detectors) {
    all.push_back(detector.keypoints_per_scan);
    for (const auto& rows : {detector.map, detector.map_shuffled}) {
      for (const auto& row : rows) {
        all.insert(all.end(),
                   {row.landmarks, row.mean_deviation, row.max_deviation, row.single_share});
      }
    }
    for (const auto& values :
         {detector.repeatability.viewpoint, detector.repeatability.noise,
          detector.repeatability.subsampling, detector.repeatability.oversampling,
          std::vector<MeanValue>{detector.repeatability.start_angle}}) {
      add_values(values);
    }
  }
  for (const auto& descriptors : evaluation.descriptors) {
    for (const auto& curves : descriptors.conditions) {
      for (const auto& curve : curves.curves) {
        for (const auto& point : curve.points) {
          all.insert(all.end(), {point.threshold, point.precision, point.recall});
        }
      }
    }
  }
  return all;
}

class EvaluateFeatures : public ::testing::Test {
 protected:
  EvaluateFeatures() {
    auto random = test::seeded_random();
    for (const Pose2& pose : office_path(0.9)) {
      if (scans_.size() == 12) break;
      scans_.push_back({test::closed_scan(office_scene(), pose, 360, 0.01, random), pose});
    }
    params_.repeatability.reference_scans = 4;
  }

  FeatureEvaluation evaluate() const {
    return evaluate_features(scans_, params_, [](const std::string&) {});
  }

  std::vector<PosedScan> scans_;
  FeatureEvaluationParams params_;
};

TEST_F(EvaluateFeatures, RepeatsWithItsSeed) {
  const auto once = figures(evaluate());
  EXPECT_EQ(figures(evaluate()), once);
  params_.repeatability.seed = 2;
  EXPECT_NE(figures(evaluate()), once);
}

TEST_F(EvaluateFeatures, TheStartAngleIsNothingToFalko) {
  const DetectorEvaluation falko = evaluate().detectors.at(0);
  EXPECT_EQ(falko.repeatability.start_angle.count, 4U * params_.repeatability.start_angles.size());
  EXPECT_EQ(falko.repeatability.start_angle.mean, 1.0);
}

TEST_F(EvaluateFeatures, ComparesFiveDetectors) {
  std::vector<std::string> told;
  const auto evaluation =
      evaluate_features(scans_, params_, [&](const std::string& what) { told.push_back(what); });
  ASSERT_EQ(evaluation.detectors.size(), 5U);
  for (const auto& detector : evaluation.detectors) {
    EXPECT_GT(detector.keypoints_per_scan, 0.0) << detector.name;
    EXPECT_EQ(detector.map.size(), params_.map_radii.size());
    EXPECT_NE(std::find(told.begin(), told.end(), detector.name), told.end()) << detector.name;
  }
}

TEST_F(EvaluateFeatures, ComparesThreeDescriptorsOnTheKeypointsOfTwoDetectors) {
  const auto evaluation = evaluate();
  ASSERT_EQ(evaluation.descriptors.size(), 2U);
  EXPECT_EQ(evaluation.descriptors[0].detector, "FALKO");
  EXPECT_EQ(evaluation.descriptors[1].detector, "FLIRT curvature");
  for (const auto& descriptors : evaluation.descriptors) {
    ASSERT_EQ(descriptors.conditions.size(), 4U);
    for (const auto& condition : descriptors.conditions) {
      ASSERT_EQ(condition.curves.size(), 3U);
      EXPECT_EQ(condition.curves[2].descriptor, "beta-grid");
    }
  }
}

TEST_F(EvaluateFeatures, CountsTheKeypointsOfAllScans) {
  FalkoDetector detector;
  double keypoints = 0.0;
  for (const auto& posed : scans_) {
    keypoints += static_cast<double>(detector.detect(posed.scan).size());
  }
  const auto evaluation = evaluate();
  EXPECT_EQ(evaluation.scans, 12U);
  EXPECT_NEAR(evaluation.detectors[0].keypoints_per_scan, keypoints / 12.0, 1e-9);
}

}  // namespace
}  // namespace falko_slam
