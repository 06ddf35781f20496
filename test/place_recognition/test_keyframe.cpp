// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

LaserScan scan_of(const Scene& scene) {
  auto random = test::seeded_random();
  return test::closed_scan(scene, {}, 720, 0.01, random);
}

TEST(KeyframeBuilder, RemembersCornersAndWallEndsWithTheirOrientation) {
  const LaserScan scan = scan_of(test::room_with_pillar());
  const auto corners = FalkoDetector(KeyframeParams::loose_falko_params()).detect(scan);
  const auto ends = find_wall_ends(scan);
  ASSERT_FALSE(corners.empty() || ends.empty());
  const Keyframe keyframe = KeyframeBuilder().build(scan);
  ASSERT_EQ(keyframe.points.size(), corners.size() + ends.size());
  for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
    const Keypoint& from = i < corners.size() ? corners[i] : ends[i - corners.size()];
    EXPECT_EQ(keyframe.points[i].position, from.position);
    EXPECT_EQ(keyframe.points[i].orientation, from.orientation);
  }
}

TEST(KeyframeBuilder, HasASignatureOfPointsBesideOneOfWalls) {
  const KeyframeParams params;
  const Keyframe keyframe = KeyframeBuilder(params).build(scan_of(test::room_with_pillar()));
  EXPECT_FALSE(keyframe.signature.empty());
  EXPECT_EQ(keyframe.signature.rows, params.glare.direction_cells);
  EXPECT_EQ(keyframe.signature.columns, 2 * params.glare.distance_cells);
}

TEST(KeyframeBuilder, MakesNothingOfAScanWithoutAValidBeam) {
  const Keyframe keyframe = KeyframeBuilder().build(test::round_scan(test::kNoRange));
  EXPECT_TRUE(keyframe.points.empty());
  EXPECT_TRUE(keyframe.signature.empty());
  EXPECT_TRUE(keyframe.view.points().empty());
}

TEST(KeyframeBuilder, KeepsNothingOfTheScanBefore) {
  const LaserScan scan = scan_of(test::room_with_pillar());
  KeyframeBuilder builder;
  const Keyframe first = builder.build(scan);
  builder.build(test::round_scan(3.0));
  const Keyframe again = builder.build(scan);
  ASSERT_EQ(again.points.size(), first.points.size());
  EXPECT_EQ(shifted_distance(again.signature, first.signature).distance, 0U);
}

TEST(SampledWalls, AreTheSpacingApartAlongAWall) {
  constexpr double kSpacing = 0.30;
  const ScanView view(test::round_scan(3.0, 720));
  const auto samples = sampled_walls(view, kSpacing, 12.0);
  ASSERT_GT(samples.size(), 10U);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    // Way is measured along the points of the view, the next of which is up to 2 spacings farther.
    const double step = (samples[i] - samples[i - 1]).norm();
    EXPECT_GT(step, kSpacing - 0.01);
    EXPECT_LT(step, kSpacing + 2.0 * ScanViewParams().point_spacing);
  }
}

TEST(SampledWalls, StartAnewBehindAGap) {
  std::vector<double> ranges(720, test::kNoRange);
  for (const std::size_t first : {100U, 400U}) {
    for (std::size_t i = 0; i < 4; ++i) ranges[first + i] = 3.0;  // 10 cm of wall
  }
  EXPECT_EQ(sampled_walls(ScanView(test::circle_of(ranges)), 0.30, 12.0).size(), 2U);
}

TEST(SampledWalls, LeaveOutWhatIsTooFar) {
  const ScanView view(test::round_scan(3.0, 720));
  EXPECT_TRUE(sampled_walls(view, 0.30, 2.9).empty());
  EXPECT_FALSE(sampled_walls(view, 0.30, 3.1).empty());
}

TEST(SampledWalls, OfNothingAreNone) { EXPECT_TRUE(sampled_walls(ScanView(), 0.30, 12.0).empty()); }

TEST(KeyframeParams, NamesFieldAndValueOfWhatIsWrong) {
  KeyframeParams params;
  params.wall_spacing = 0.0;
  try {
    KeyframeBuilder builder(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("wall_spacing = 0: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
