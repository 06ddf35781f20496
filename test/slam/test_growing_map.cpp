// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/growing_map.hpp"

#include <gtest/gtest.h>

#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

std::vector<MappedScan> office_scans(std::size_t count) {
  auto random = test::seeded_random();
  const Scene scene = office_scene();
  const std::vector<Pose2> path = office_path(1.0);
  std::vector<MappedScan> scans;
  for (std::size_t i = 0; i < count; ++i) {
    scans.push_back(
        {std::make_shared<LaserScan>(test::closed_scan(scene, path[i], 180, 0.01, random)),
         path[i]});
  }
  return scans;
}

GridMap at_once(const std::vector<MappedScan>& scans) {
  std::vector<ScanAtPose> all;
  for (const MappedScan& scan : scans) all.push_back({scan.scan.get(), scan.map_T_laser});
  return build_occupancy_grid(all);
}

void expect_same(const GridMap& a, const GridMap& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.map_T_origin.translation(), b.map_T_origin.translation());
}

TEST(GrowingMap, IsThatOfAllScansAtOnce) {
  GrowingMap map;
  EXPECT_TRUE(map.draw({}).cells.empty());
  const auto scans = office_scans(9);
  for (const long count : {2L, 5L, 5L, 9L}) {
    const std::vector<MappedScan> first(scans.begin(), scans.begin() + count);
    expect_same(map.draw(first), at_once(first));
  }
  EXPECT_EQ(map.redrawn(), 0U);
}

TEST(GrowingMap, FollowsScansThatMove) {
  GrowingMap map;
  auto scans = office_scans(6);
  map.draw(scans);
  scans[2].map_T_laser = scans[2].map_T_laser * Pose2(0.3, 0.0, 0.02);
  expect_same(map.draw(scans), at_once(scans));
  EXPECT_EQ(map.redrawn(), 1U);
}

TEST(GrowingMap, ForgetsScansThatAreGone) {
  GrowingMap map;
  auto scans = office_scans(6);
  map.draw(scans);
  scans.resize(2);
  expect_same(map.draw(scans), at_once(scans));
  EXPECT_TRUE(map.draw({}).cells.empty());
}

}  // namespace
}  // namespace falko_slam
