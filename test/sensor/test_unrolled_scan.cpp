// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/unrolled_scan.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

using Surface = std::pair<std::size_t, std::size_t>;

// 360 beams of a box of 10 m by 8 m about the laser, and of a block in it that hides the seam or
// not.
LaserScan boxed(double heading) {
  Scene scene;
  scene.add_box({}, {10.0, 8.0});
  scene.add_box({2.5, 0.0, 0.0}, {1.0, 1.0});
  auto random = test::seeded_random();
  return test::closed_scan(scene, {0.0, 0.0, heading}, 360, 0.0, random);
}

std::vector<Surface> runs_of(const UnrolledScan& scan) {
  std::vector<Surface> runs;
  scan.for_each_surface(
      [&](std::size_t first, std::size_t last) { runs.emplace_back(first, last); });
  return runs;
}

TEST(UnrolledScan, CutsNoSurfaceAtTheSeam) {
  for (const double heading : {0.0, 1.0, -2.0, 3.1}) {
    const LaserScan scan = boxed(heading);
    const auto runs = runs_of(UnrolledScan(scan, 100.0, {}));
    ASSERT_EQ(runs.size(), 2U) << heading;
    EXPECT_EQ(runs[0].first, 0U);
    EXPECT_EQ(runs[1].first, runs[0].second + 1);
    EXPECT_EQ(runs[1].second, scan.size() - 1);
  }
}

TEST(UnrolledScan, KnowsWhichBeamIsWhere) {
  const LaserScan scan = boxed(3.1);
  const UnrolledScan unrolled(scan, 100.0, {});
  for (std::size_t k = 0; k < scan.size(); ++k) {
    EXPECT_EQ(unrolled.place_of(unrolled.beam_of(k)), k);
    EXPECT_EQ(unrolled.point(k), scan.point(unrolled.beam_of(k)));
  }
}

TEST(UnrolledScan, BeginsAtTheFirstBeamOfAScanThatIsOpenOrRoundAbout) {
  LaserScan scan = boxed(3.1);
  scan.closed = false;
  const UnrolledScan open(scan, 100.0, {});
  EXPECT_EQ(open.beam_of(0), 0U);
  Scene empty_box;
  empty_box.add_box({}, {10.0, 8.0});
  auto random = test::seeded_random();
  const UnrolledScan round(test::closed_scan(empty_box, {}, 360, 0.0, random), 100.0, {});
  EXPECT_EQ(runs_of(round), (std::vector<Surface>{{0, 359}}));
}

TEST(UnrolledScan, LeavesOutWhatIsInvalidOrTooFar) {
  LaserScan scan = boxed(0.0);
  scan.status[90] = BeamStatus::kErroneous;
  const UnrolledScan unrolled(scan, 4.2, {});
  const std::size_t k = unrolled.place_of(90);
  EXPECT_FALSE(unrolled.usable(k));
  EXPECT_EQ(unrolled.range(k), 0.0);
  for (const auto& [first, last] : runs_of(unrolled)) {
    for (std::size_t i = first; i <= last; ++i) {
      EXPECT_GT(unrolled.range(i), 0.0);
      EXPECT_LE(unrolled.range(i), 4.2);
    }
  }
}

TEST(UnrolledScan, OfNothingHasNothing) {
  EXPECT_TRUE(runs_of(UnrolledScan()).empty());
  LaserScan nothing;
  nothing.closed = true;
  EXPECT_TRUE(runs_of(UnrolledScan(nothing, 10.0, {})).empty());
}

}  // namespace
}  // namespace falko_slam
