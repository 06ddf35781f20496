// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scan_sight.hpp"

#include <gtest/gtest.h>

#include "localization/scan_of_room.hpp"

namespace falko_slam {
namespace {

TEST(ScanSight, ReachesWhatNothingHides) {
  const LaserScan scan = test::scan_of(test::room_with_box(), {});
  const ScanSight sight(scan);

  EXPECT_TRUE(sight.reaches({4.9, 0.0}, 0.1, 0.3));
  EXPECT_TRUE(sight.reaches({-5.0, 0.0}, 0.1, 0.3)) << "across the seam";
  EXPECT_FALSE(sight.reaches({4.6, 2.3}, 0.1, 0.3)) << "behind the box";
  EXPECT_FALSE(sight.reaches({5.6, 0.0}, 0.1, 0.3)) << "behind the wall";
  EXPECT_TRUE(sight.reaches({5.6, 0.0}, 0.1, 0.7)) << "within the margin";
}

TEST(ScanSight, KnowsNothingWhereNoBeamLooks) {
  LaserScan scan = test::scan_of(test::room_with_box(), {});
  scan.closed = false;
  scan.ranges.resize(180);
  scan.status.resize(180);
  EXPECT_FALSE(ScanSight(scan).reaches({0.0, 2.0}, 0.1, 0.3));
  EXPECT_TRUE(ScanSight(scan).reaches({0.0, -2.0}, 0.1, 0.3));
  scan.status.assign(180, BeamStatus::kNoReturn);
  EXPECT_FALSE(ScanSight(scan).reaches({0.0, -2.0}, 0.1, 0.3));
  EXPECT_FALSE(ScanSight(LaserScan{}).reaches({0.0, -2.0}, 0.1, 0.3));
}

}  // namespace
}  // namespace falko_slam
