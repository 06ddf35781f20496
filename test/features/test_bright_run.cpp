// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "bright_run.hpp"

#include <gtest/gtest.h>

#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

std::vector<BeamRun> runs_of(const LaserScan& scan, const std::vector<char>& members) {
  std::vector<BeamRun> runs;
  find_runs(
      scan, [&](std::size_t i) { return members[i] != 0; },
      [](std::size_t, std::size_t) { return true; }, runs);
  return runs;
}

std::vector<BrightBeam> beams_of(const std::vector<double>& excess) {
  std::vector<BrightBeam> beams;
  for (const double value : excess) beams.push_back({value, 5.0, 100.0F});
  return beams;
}

TEST(BrightRun, IsOneAcrossTheSeamOfAClosedScanOnly) {
  LaserScan scan = test::round_scan(3.0, 6);
  const std::vector<char> members = {1, 0, 1, 0, 1, 1};
  const auto closed = runs_of(scan, members);
  ASSERT_EQ(closed.size(), 2U);
  EXPECT_EQ(closed[1].first, 4U);
  EXPECT_EQ(closed[1].count, 3U);
  scan.closed = false;
  EXPECT_EQ(runs_of(scan, members).size(), 3U);
}

TEST(BrightRun, OfAllBeamsOfAClosedScanHasNoBeginning) {
  EXPECT_TRUE(runs_of(test::round_scan(3.0, 6), std::vector<char>(6, 1)).empty());
  EXPECT_TRUE(runs_of(LaserScan(), {}).empty());
}

TEST(BrightProfile, HasItsMiddleAndHalfWidthBetweenBeams) {
  const auto beams = beams_of({2.0, 4.0, 4.0, 2.0});
  const BrightProfile profile = profile_of(beams.data(), beams.size());
  EXPECT_EQ(profile.middle, 1.5);
  EXPECT_EQ(profile.peak, 4.0);
  EXPECT_EQ(profile.half_begin, 0.0);
  EXPECT_EQ(profile.half_end, 3.0);
  const auto one = beams_of({4.0});
  EXPECT_EQ(profile_of(one.data(), 1).half_width(), 1.0);
}

TEST(BrightProfile, HasAValleyBetweenTwoPeaks) {
  const auto beams = beams_of({1.0, 5.0, 2.0, 1.0, 4.0, 1.0});
  EXPECT_EQ(valley_of(beams.data(), beams.size(), 1.4), 3U);
  EXPECT_EQ(valley_of(beams.data(), beams.size(), 4.5), beams.size());
  const auto one_peak = beams_of({1.0, 3.0, 5.0, 2.0});
  EXPECT_EQ(valley_of(one_peak.data(), one_peak.size(), 1.4), one_peak.size());
}

}  // namespace
}  // namespace falko_slam
