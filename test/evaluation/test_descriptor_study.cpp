// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/descriptor_study.hpp"

#include <gtest/gtest.h>

#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

ComparedFeature described(const Eigen::Vector2d& position, unsigned cells, float share) {
  ComparedFeature feature;
  feature.keypoint.position = position;
  feature.bsc.words = {cells};
  feature.cgh.bins = {share, 1.0F - share};
  feature.beta_grid = {{share, 0.5F}, {0.05F, 0.08F}};
  return feature;
}

// Two points that look different from each other, and the same in every scan.
std::vector<ComparedFeature> telling(const LaserScan&) {
  return {described({1.0, 0.0}, 0x0fU, 0.2F), described({0.0, 1.0}, 0xf0U, 0.9F)};
}

// Two points of which each looks as the other does in the scan before.
class Misleading {
 public:
  std::vector<ComparedFeature> operator()(const LaserScan& scan) {
    auto features = telling(scan);
    if (swap_) std::swap(features[0].keypoint, features[1].keypoint);
    swap_ = !swap_;
    return features;
  }

 private:
  bool swap_ = false;
};

class StudyDescriptors : public ::testing::Test {
 protected:
  std::vector<DescriptorCurves> study(const FeatureFunction& extract) const {
    return study_descriptors(scans_, cases_, conditions_, params_, extract);
  }

  std::vector<PosedScan> scans_ = {{test::round_scan(3.0, 36), {}},
                                   {test::round_scan(3.0, 36), {}}};
  RepeatabilityCases cases_ = {{0}, {{0, 1, 0.7}}};
  RepeatabilityParams conditions_;
  DescriptorStudyParams params_;
};

TEST_F(StudyDescriptors, GoesThroughItsConditions) {
  const auto curves = study(telling);
  ASSERT_EQ(curves.size(), 4U);
  EXPECT_EQ(curves[0].condition, "viewpoint");
  EXPECT_EQ(curves[1].condition, "noise");
  EXPECT_EQ(curves[2].condition, "subsampling");
  EXPECT_EQ(curves[3].condition, "oversampling");
}

TEST_F(StudyDescriptors, DescriptorsThatTellPointsApartArePureAndComplete) {
  for (const auto& curves : study(telling)) {
    ASSERT_EQ(curves.curves.size(), 3U);
    for (const auto& [descriptor, curve] : curves.curves) {
      ASSERT_EQ(curve.size(), 1U) << curves.condition << " " << descriptor;
      EXPECT_EQ(curve[0].threshold, 0.0);
      EXPECT_EQ(curve[0].precision, 1.0);
      EXPECT_EQ(curve[0].recall, 1.0);
    }
  }
}

TEST_F(StudyDescriptors, DescriptorsThatMisleadAreAtTheLevelOfChance) {
  conditions_.noise_levels.clear();
  conditions_.sampling_levels.clear();
  const auto curves = study(Misleading());
  // Both pairs of one point have the distance at which all four pairs are taken.
  for (const auto& [descriptor, curve] : curves[0].curves) {
    ASSERT_EQ(curve.size(), 1U) << descriptor;
    EXPECT_EQ(curve[0].precision, 0.5) << descriptor;
  }
  EXPECT_EQ(curves[0].curves[0].descriptor, "BSC");
  EXPECT_EQ(curves[0].curves[0].points[0].threshold, 8.0);
}

TEST_F(StudyDescriptors, LeavesOutPairsOfOtherOverlaps) {
  for (const double overlap : {0.45, 0.95}) {
    cases_.viewpoints[0].overlap = overlap;
    const auto curves = study(telling);
    for (const auto& curve : curves[0].curves) EXPECT_TRUE(curve.points.empty()) << overlap;
  }
}

TEST_F(StudyDescriptors, ComparesPointsInTheMap) {
  // Nothing is the same point once the second scan stands 5 m off.
  scans_[1].map_T_laser = {5.0, 0.0, 0.0};
  const auto curves = study(telling);
  for (std::size_t i = 0; i < curves[0].curves.size(); ++i) {
    EXPECT_TRUE(curves[0].curves[i].points.empty());
    EXPECT_FALSE(curves[1].curves[i].points.empty());
  }
}

}  // namespace
}  // namespace falko_slam
