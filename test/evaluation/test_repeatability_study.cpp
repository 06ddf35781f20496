// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/repeatability_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

// Round scans in a row, 0.4 m apart.
std::vector<PosedScan> row_of_scans(std::size_t count) {
  std::vector<PosedScan> scans;
  for (std::size_t i = 0; i < count; ++i) {
    scans.push_back({test::round_scan(3.0, 90), {0.4 * static_cast<double>(i), 0.0, 0.1}});
  }
  return scans;
}

RepeatabilityCases only(std::size_t reference) { return {{reference}, {}}; }

Keypoint keypoint_at(const Eigen::Vector2d& position) {
  Keypoint keypoint;
  keypoint.position = position;
  return keypoint;
}

std::vector<Keypoint> end_of_first_beam(const LaserScan& scan) {
  return {keypoint_at(scan.point(0))};
}

std::vector<Keypoint> nothing(const LaserScan&) { return {}; }

TEST(ChooseCases, DrawsDifferentReferences) {
  RepeatabilityParams params;
  params.reference_scans = 7;
  const auto references = choose_cases(row_of_scans(12), params).references;
  EXPECT_EQ(references.size(), 7U);
  EXPECT_EQ(std::set<std::size_t>(references.begin(), references.end()).size(), 7U);
  EXPECT_LT(*std::max_element(references.begin(), references.end()), 12U);
}

TEST(ChooseCases, TakesAllScansWhereThereAreFewer) {
  const auto references = choose_cases(row_of_scans(4), {}).references;
  EXPECT_EQ(std::set<std::size_t>(references.begin(), references.end()),
            (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST(ChooseCases, RepeatsWithItsSeed) {
  RepeatabilityParams params;
  const auto scans = row_of_scans(12);
  const auto references = choose_cases(scans, params).references;
  EXPECT_EQ(choose_cases(scans, params).references, references);
  params.seed = 2;
  EXPECT_NE(choose_cases(scans, params).references, references);
}

TEST(ChooseCases, PairsScansThatAreNear) {
  const auto scans = row_of_scans(5);
  const auto cases = choose_cases(scans, {});
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& pair : cases.viewpoints) {
    EXPECT_LT((scans[pair.reference].map_T_laser.translation() -
               scans[pair.other].map_T_laser.translation())
                  .norm(),
              1.0);
    EXPECT_NE(pair.reference, pair.other);
    EXPECT_GT(pair.overlap, 0.5);
    EXPECT_LT(pair.overlap, 1.0);
    pairs.insert({pair.reference, pair.other});
  }
  // Neighbours and their neighbours, in both directions: (4 + 3) * 2.
  EXPECT_EQ(pairs.size(), 14U);
  EXPECT_EQ(cases.viewpoints.size(), 14U);
}

TEST(StudyRepeatability, AKeypointThatTurnsWithTheScanIsRepeatable) {
  const auto result = study_repeatability(row_of_scans(1), only(0), {}, end_of_first_beam);
  EXPECT_EQ(result.start_angle.count, 5U);
  EXPECT_EQ(result.start_angle.mean, 1.0);
}

TEST(StudyRepeatability, AKeypointThatStaysWhereTheScanTurnsIsNot) {
  const auto fixed = [](const LaserScan&) {
    return std::vector<Keypoint>{keypoint_at({5.0, 0.0})};
  };
  const auto result = study_repeatability(row_of_scans(1), only(0), {}, fixed);
  // Turned back by 0.01 rad it lies 0.05 m off; by 0.5 rad and more, metres.
  EXPECT_NEAR(result.start_angle.mean, 1.0 / 5.0, 1e-12);
  EXPECT_EQ(result.subsampling[0].mean, 1.0);
}

TEST(StudyRepeatability, NoiseMovesKeypointsOutOfReach) {
  RepeatabilityParams params;
  params.noise_levels = {1e-6, 1e6};
  const auto result = study_repeatability(row_of_scans(1), only(0), params, end_of_first_beam);
  ASSERT_EQ(result.noise.size(), 2U);
  EXPECT_EQ(result.noise[0].mean, 1.0);
  EXPECT_EQ(result.noise[1].mean, 0.0);
}

TEST(StudyRepeatability, ScansWithoutKeypointsCountZeroUnlessTheyAreTheReference) {
  const auto in_large_scans = [](const LaserScan& scan) {
    return scan.size() == 90 ? end_of_first_beam(scan) : nothing(scan);
  };
  const auto scans = row_of_scans(1);
  const auto lost = study_repeatability(scans, only(0), {}, in_large_scans);
  EXPECT_EQ(lost.subsampling[0].count, 1U);
  EXPECT_EQ(lost.subsampling[0].mean, 0.0);
  EXPECT_EQ(lost.oversampling[3].mean, 0.0);
  const auto never = study_repeatability(scans, only(0), {}, nothing);
  EXPECT_EQ(never.subsampling[0].count + never.noise[0].count + never.start_angle.count, 0U);
}

TEST(StudyRepeatability, SortsViewpointsByOverlap) {
  const auto scans = row_of_scans(2);
  const RepeatabilityCases cases = {{}, {{0, 1, 0.05}, {1, 0, 0.55}, {0, 1, 1.0}}};
  // The end of the first beam moves along with the laser by 0.4 m.
  RepeatabilityParams params;
  params.association_radius = 0.5;
  const auto result = study_repeatability(scans, cases, params, end_of_first_beam);
  ASSERT_EQ(result.viewpoint.size(), 10U);
  for (const std::size_t bin : {0U, 5U, 9U}) {
    EXPECT_EQ(result.viewpoint[bin].count, 1U) << bin;
    EXPECT_EQ(result.viewpoint[bin].mean, 1.0) << bin;
  }
  EXPECT_EQ(result.viewpoint[1].count, 0U);
  params.association_radius = 0.3;
  EXPECT_EQ(study_repeatability(scans, cases, params, end_of_first_beam).viewpoint[5].mean, 0.0);
}

TEST(MeanValue, IsTheMeanOfWhatWasAdded) {
  MeanValue value;
  for (const double x : {1.0, 2.0, 6.0}) value.add(x);
  EXPECT_NEAR(value.mean, 3.0, 1e-12);
  EXPECT_EQ(value.count, 3U);
}

}  // namespace
}  // namespace falko_slam
