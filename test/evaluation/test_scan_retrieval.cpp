// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_retrieval.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/features/falko.hpp"
#include "support/drives.hpp"
#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

using Make = ScanRetrieval (*)(const std::vector<PosedScan>&, const ScanKeypoints&);

// The retrievals by signatures on a way along the corridor, whose last scan is taken where the
// first one was. (That by phrases is tested in test_thesis_methods.cpp.)
class Retrievals : public ::testing::TestWithParam<Make> {
 protected:
  Retrievals() {
    auto random = test::seeded_random();
    auto path = test::straight({-8.0, -1.0, 0.0}, 10.0, 0.8);
    path.push_back(path.front());
    scans_ = test::drive(office_scene(), path, random);
    FalkoDetector falko;
    for (const PosedScan& scan : scans_) keypoints_.push_back(falko.detect(scan.scan));
  }

  std::vector<PosedScan> scans_;
  ScanKeypoints keypoints_;
};

TEST_P(Retrievals, FindTheScanOfTheSamePlaceFirst) {
  const auto retrieval = GetParam()(scans_, keypoints_);
  const std::size_t last = scans_.size() - 1;
  const auto found = retrieval.nearest(last, 3, [&](std::size_t target) { return target != last; });
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found.front(), 0U);
}

TEST_P(Retrievals, FindTheScanItselfIfThatIsAdmitted) {
  const auto retrieval = GetParam()(scans_, keypoints_);
  for (std::size_t scan = 0; scan < scans_.size(); ++scan) {
    if (keypoints_[scan].size() < 3) continue;  // nothing to know it by
    EXPECT_EQ(retrieval.nearest(scan, 1, [](std::size_t) { return true; }).at(0), scan);
  }
}

TEST_P(Retrievals, GiveOnlyAdmittedScansAndNoneTwice) {
  const auto retrieval = GetParam()(scans_, keypoints_);
  auto found = retrieval.nearest(2, 100, [](std::size_t target) { return target % 2 == 0; });
  EXPECT_LE(found.size(), (scans_.size() + 1) / 2);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::unique(found.begin(), found.end()), found.end());
  for (const std::size_t target : found) EXPECT_EQ(target % 2, 0U);
  EXPECT_TRUE(retrieval.nearest(2, 10, [](std::size_t) { return false; }).empty());
}

TEST_P(Retrievals, SurviveScansWithoutKeypoints) {
  const std::vector<PosedScan> scans(3, {test::round_scan(5.0), {}});
  const auto retrieval = GetParam()(scans, ScanKeypoints(3));
  EXPECT_LE(retrieval.nearest(0, 10, [](std::size_t) { return true; }).size(), 3U);
  EXPECT_EQ(GetParam()({}, {}).creation.mean, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    All, Retrievals,
    ::testing::Values([](const std::vector<PosedScan>&,
                         const ScanKeypoints& keypoints) { return glarot_retrieval(keypoints); },
                      [](const std::vector<PosedScan>& scans, const ScanKeypoints& keypoints) {
                        return gsr_retrieval(scans, keypoints);
                      },
                      [](const std::vector<PosedScan>& scans, const ScanKeypoints& keypoints) {
                        return gsr_retrieval(scans, keypoints, {}, KeypointNormals::kGrid);
                      }));

}  // namespace
}  // namespace falko_slam
