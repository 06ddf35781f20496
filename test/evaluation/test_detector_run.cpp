// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/detector_run.hpp"

#include <gtest/gtest.h>

#include "support/drives.hpp"

namespace falko_slam {
namespace {

TEST(DetectorRun, TellsWhatTheDetectorAcceptsByItself) {
  auto random = test::seeded_random();
  const auto scans =
      test::drive(office_scene(), test::straight({-8.0, -1.0, 0.0}, 6.0, 0.3), random);
  DetectorRun run(scans);
  const LoopTruth truth(scans, LoopProtocol::kOffline);
  const LoopMethodResult result = run.close_all(truth);
  EXPECT_EQ(result.method, "falko_slam");
  ASSERT_TRUE(result.accepted.has_value());
  EXPECT_EQ(result.accepted->min_score, LoopDetectorParams().min_score);

  std::size_t accepted = 0;
  for (std::size_t source = 0; source < scans.size(); ++source) {
    const auto detection = run.detector().detect(
        {source}, [&](const Keyframe& target) { return target.id.value != source; });
    accepted += detection.accepted() != nullptr ? 1U : 0U;
  }
  EXPECT_GT(accepted, 0U);
  EXPECT_EQ(result.accepted->closures, accepted);
  EXPECT_FALSE(result.search.has_value());  // its parts are not timed apart
}

}  // namespace
}  // namespace falko_slam
