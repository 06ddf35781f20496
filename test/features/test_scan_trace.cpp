// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_trace.hpp"

#include <gtest/gtest.h>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

TEST(ScanTrace, HoldsTheValidPointsInOrder) {
  ScanTrace trace;
  trace.assign(test::scan_of({2.0, test::kNoRange, 2.1, 2.2}, 0.5, 0.01), 1.0);
  EXPECT_EQ(trace.beam, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(trace.range, (std::vector<double>{2.0, 2.1, 2.2}));
  EXPECT_EQ(trace.start_bearing(), 0.5);
  EXPECT_NEAR(trace.x[1], 2.1 * std::cos(0.02), 1e-12);
  EXPECT_NEAR(trace.y[1], 2.1 * std::sin(0.02), 1e-12);
  ASSERT_EQ(trace.pieces().size(), 1U);
}

TEST(ScanTrace, IsCutAtGapsAndTellsWhatLiesBeyond) {
  ScanTrace trace;
  trace.assign(test::scan_of({2.0, 2.0, 2.0, 4.0, 4.0}, 0.0, 0.01), 1.0);
  ASSERT_EQ(trace.pieces().size(), 2U);
  EXPECT_EQ(trace.pieces()[0].end, 3U);
  EXPECT_EQ(trace.pieces()[1].begin, 3U);
  EXPECT_FALSE(trace.pieces()[0].before.exists);
  ASSERT_TRUE(trace.pieces()[0].after.exists);
  EXPECT_EQ(trace.pieces()[0].after.range, 4.0);
  EXPECT_EQ(trace.pieces()[1].before.range, 2.0);
  EXPECT_FALSE(trace.pieces()[1].after.exists);
}

TEST(ScanTrace, OfAClosedScanDoesNotDependOnItsStart) {
  std::vector<double> ranges;
  for (int i = 0; i < 12; ++i) ranges.push_back(i % 4 == 1 ? 0.8 : 0.9);  // a period of 4 beams
  ranges[7] = test::kNoRange;
  for (const double max_gap : {0.05, 0.3, 2.0}) {
    const LaserScan scan = test::circle_of(ranges);
    ScanTrace trace, turned;
    trace.assign(scan, max_gap);
    for (std::size_t by = 1; by < 12; ++by) {
      turned.assign(with_beams_rotated(scan, by), max_gap);
      EXPECT_EQ(turned.x, trace.x) << max_gap << " " << by;
      EXPECT_EQ(turned.y, trace.y) << max_gap << " " << by;
      EXPECT_EQ(turned.bearing, trace.bearing) << max_gap << " " << by;
      ASSERT_EQ(turned.pieces().size(), trace.pieces().size());
      for (std::size_t i = 0; i < trace.size(); ++i) {
        EXPECT_EQ((turned.beam[i] + by) % 12, trace.beam[i]);
      }
    }
  }
}

TEST(ScanTrace, ContinuesALoopByHalfOfItOnBothSides) {
  ScanTrace trace;
  trace.assign(test::round_scan(1.0, 36), 1.0);
  ASSERT_EQ(trace.pieces().size(), 1U);
  EXPECT_EQ(trace.size(), 72U);
  EXPECT_EQ(trace.pieces()[0].first, 18U);
  EXPECT_EQ(trace.pieces()[0].last, 54U);
  for (std::size_t i = 1; i < trace.size(); ++i) {
    EXPECT_EQ(trace.beam[i], (trace.beam[i - 1] + 1) % 36);
    EXPECT_NEAR(trace.bearing[i] - trace.bearing[i - 1], 0.17453, 1e-4);
  }
}

TEST(ScanTrace, IsNoLoopIfMostOfTheCircleIsMissing) {
  std::vector<double> ranges(360, test::kNoRange);
  for (std::size_t i = 0; i < 5; ++i) ranges[100 + i] = 2.0;
  ScanTrace trace;
  trace.assign(test::circle_of(ranges), 1.0);
  EXPECT_EQ(trace.size(), 5U);
}

TEST(ScanTrace, OfNothingIsEmpty) {
  ScanTrace trace;
  trace.assign(test::circle_of({test::kNoRange, test::kNoRange}), 1.0);
  EXPECT_EQ(trace.size(), 0U);
  EXPECT_TRUE(trace.pieces().empty());
}

}  // namespace
}  // namespace falko_slam
