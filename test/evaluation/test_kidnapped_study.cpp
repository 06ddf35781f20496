// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/kidnapped_study.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/drives.hpp"

namespace falko_slam {
namespace {

// Along the corridor of the office, and once more beside the first time.
std::vector<PosedScan> two_passes() {
  auto random = test::seeded_random();
  const auto first = test::straight({-8.0, -1.0, 0.0}, 14.0, 0.5);
  test::Poses path = first;
  for (const Pose2& pose : first) path.push_back(pose * Pose2(0.1, 0.1, 0.05));
  return test::drive(office_scene(), path, random);
}

TEST(StudyKidnapped, FindsPlacesSeenAtAnotherTime) {
  const auto scans = two_passes();
  DetectorRun run(scans);
  const KidnappedResult result = study_kidnapped(scans, run);
  EXPECT_EQ(result.scans, scans.size());
  // 14 m of way and the jump back lie between the passes: all but nothing was seen twice.
  EXPECT_EQ(result.visited, scans.size());
  EXPECT_GT(result.best_right, 0.9);
  EXPECT_GE(result.any_right, result.best_right);
  EXPECT_EQ(result.travelled.protocol, LoopProtocol::kKidnapped);
  EXPECT_EQ(result.travelled.loops, result.visited);
}

TEST(StudyKidnapped, AcceptsBothEarlierAndLaterPlaces) {
  const auto scans = two_passes();
  DetectorRun run(scans);
  const LoopMethodResult travelled = study_kidnapped(scans, run).travelled;
  ASSERT_TRUE(travelled.accepted.has_value());
  // The second pass alone would be half of them.
  EXPECT_GT(travelled.accepted->closures, scans.size() / 2);
  EXPECT_EQ(travelled.accepted->wrong, 0U);
}

TEST(StudyKidnapped, OfPlacesSeenOnceHasNothingToFind) {
  auto random = test::seeded_random();
  const auto scans =
      test::drive(office_scene(), test::straight({-8.0, -1.0, 0.0}, 8.0, 0.5), random);
  DetectorRun run(scans);
  const KidnappedResult result = study_kidnapped(scans, run);
  EXPECT_EQ(result.visited, 0U);
  EXPECT_EQ(result.best_right, 0.0);
  EXPECT_EQ(result.travelled.curve.size(), 0U);  // nothing is 10 m off: nothing may be an answer
}

TEST(StudyKidnapped, OfNoScansIsEmpty) {
  DetectorRun run({});
  const KidnappedResult result = study_kidnapped({}, run);
  EXPECT_EQ(result.scans, 0U);
  EXPECT_EQ(result.best_right, 0.0);
}

TEST(StudyKidnapped, RefusesOtherScansAndNoHypotheses) {
  DetectorRun run({});
  EXPECT_THROW(study_kidnapped(two_passes(), run), std::invalid_argument);
  KidnappedParams params;
  params.hypotheses = 0;
  EXPECT_THROW(study_kidnapped({}, run, params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
