// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/occupancy_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "falko_slam/map/grid_map.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The cell of a point of the map; unknown outside of the grid.
int cell_at(const GridMap& map, double x, double y) {
  const Eigen::Vector2d point = map.map_T_origin.inverse() * Eigen::Vector2d(x, y);
  const double column = std::floor(point.x() / map.resolution);
  const double row = std::floor(point.y() / map.resolution);
  if (column < 0.0 || row < 0.0 || column >= static_cast<double>(map.width) ||
      row >= static_cast<double>(map.height)) {
    return kUnknownCell;
  }
  return map.at(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
}

LaserScan one_beam(double range) { return test::scan_of({range}, 0.0, 0.0); }

GridMap map_of(const LaserScan& scan, const OccupancyGridParams& params = {}) {
  return build_occupancy_grid({{&scan, {0.025, 0.025, 0.0}}}, params);
}

TEST(OccupancyGrid, ABeamFreesItsWayAndFillsItsEnd) {
  const GridMap map = map_of(one_beam(0.2));
  EXPECT_EQ(map.height, 1U);
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{40, 40, 40, 40, 80}));
}

TEST(OccupancyGrid, AddsLogOddsUpToTheLimits) {
  const LaserScan scan = one_beam(0.05);
  std::vector<ScanAtPose> scans(3, {&scan, {0.025, 0.025, 0.0}});
  OccupancyGridParams params;
  params.hit_probability = 2.0 / 3.0;   // odds of 2
  params.miss_probability = 1.0 / 3.0;  // and of 1/2
  EXPECT_EQ(build_occupancy_grid(scans, params).cells, (std::vector<std::int8_t>{11, 89}));
  params.min_probability = 0.2;
  params.max_probability = 0.7;
  EXPECT_EQ(build_occupancy_grid(scans, params).cells, (std::vector<std::int8_t>{20, 70}));
}

TEST(OccupancyGrid, IsEmptyWithoutScans) {
  const GridMap map = build_occupancy_grid({});
  EXPECT_EQ(map.width * map.height, 0U);
  EXPECT_TRUE(map.cells.empty());
}

TEST(OccupancyGrid, GrowsInAllDirections) {
  OccupancyGrid grid;
  const LaserScan scan = one_beam(1.0);
  for (const Pose2& pose : {Pose2(50.0, 0.0, 0.0), Pose2(-50.0, 3.0, kPi),
                            Pose2(1.0, 40.0, 0.5 * kPi), Pose2(2.0, -40.0, -0.5 * kPi)}) {
    grid.add(scan, pose);
  }
  const GridMap map = grid.rasterise();
  EXPECT_EQ(cell_at(map, 51.01, 0.01), 80);
  EXPECT_EQ(cell_at(map, -50.99, 3.01), 80);
  EXPECT_EQ(cell_at(map, 1.01, 41.01), 80);
  EXPECT_EQ(cell_at(map, 2.01, -40.99), 80);
  EXPECT_EQ(cell_at(map, 0.0, 0.0), kUnknownCell);
  EXPECT_NEAR(map.map_T_origin.x(), -51.0, 0.051);
  EXPECT_NEAR(map.map_T_origin.y(), -41.0, 0.051);
  EXPECT_LE(grid.tiles(), 12U);  // what lies between has no memory
}

TEST(OccupancyGrid, RefusesToRasteriseAContinent) {
  OccupancyGrid grid;
  grid.add(one_beam(1.0), {-9e5, -9e5, 0.0});
  grid.add(one_beam(1.0), {9e5, 9e5, 0.0});
  EXPECT_THROW(grid.rasterise(), std::runtime_error);
}

TEST(OccupancyGrid, RefusesPosesThatAreNone) {
  OccupancyGrid grid;
  EXPECT_THROW(grid.add(one_beam(1.0), {std::nan(""), 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(grid.add(one_beam(1.0), {0.0, kInfinity, 0.0}), std::invalid_argument);
  EXPECT_THROW(grid.add(one_beam(1.0), {0.0, 0.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(grid.add(one_beam(1.0), {1e9, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(build_occupancy_grid({{nullptr, {}}}), std::invalid_argument);
}

TEST(OccupancyGrid, SaysNothingWhereABeamDoesNotReturn) {
  LaserScan scan = one_beam(test::kNoRange);
  for (const BeamStatus status : {BeamStatus::kNoReturn, BeamStatus::kZero, BeamStatus::kTooNear,
                                  BeamStatus::kTooFar, BeamStatus::kErroneous}) {
    scan.status[0] = status;
    EXPECT_TRUE(map_of(scan).cells.empty());
  }
}

TEST(OccupancyGrid, FreesTheWayOfABeamWithoutReturnWhereToldTo) {
  OccupancyGridParams params;
  params.no_return_free_range = 0.1;
  LaserScan scan = one_beam(test::kNoRange);
  for (const BeamStatus status : {BeamStatus::kNoReturn, BeamStatus::kTooFar}) {
    scan.status[0] = status;
    EXPECT_EQ(map_of(scan, params).cells, (std::vector<std::int8_t>{40, 40, 40}));
  }
  scan.range_max = 0.05;
  EXPECT_EQ(map_of(scan, params).cells, (std::vector<std::int8_t>{40, 40}));
  scan.status[0] = BeamStatus::kErroneous;
  EXPECT_TRUE(map_of(scan, params).cells.empty());
}

TEST(OccupancyGrid, PutsNoObstacleBeyondTheMaximumRange) {
  OccupancyGridParams params;
  params.max_range = 0.1;
  params.max_free_range = 0.15;
  EXPECT_EQ(map_of(one_beam(0.1), params).cells, (std::vector<std::int8_t>{40, 40, 80}));
  EXPECT_EQ(map_of(one_beam(9.0), params).cells, (std::vector<std::int8_t>{40, 40, 40, 40}));
}

TEST(OccupancyGrid, ForgetsRangesThatAreNotNumbers) {
  EXPECT_TRUE(map_of(one_beam(kInfinity)).cells.empty());
  LaserScan scan = one_beam(1.0);
  scan.ranges[0] = std::nan("");
  EXPECT_TRUE(map_of(scan).cells.empty());
}

TEST(OccupancyGrid, NamesTheParameterThatIsWrong) {
  OccupancyGridParams params;
  params.max_free_range = 10.0;  // below max_range
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("max_free_range = 10"), std::string::npos);
  }
  params = {};
  params.resolution = 0.01;
  params.max_range = 41.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.resolution = std::nan("");
  EXPECT_THROW(validate(params), std::invalid_argument);
}

// A wall along x at y = 0.52, seen at grazing angles from along itself: beams that end in it
// farther away pass through the cells in which others end.
TEST(OccupancyGrid, ABeamDoesNotErodeTheWallOfItsNeighbours) {
  Scene scene;
  scene.walls.push_back({{-8.0, 0.52}, {8.0, 0.52}});
  auto random = test::seeded_random();
  const LaserScan scan = test::closed_scan(scene, {}, 3600, 0.0, random);
  const GridMap map = build_occupancy_grid(std::vector<ScanAtPose>(20, {&scan, {}}));
  for (double x = -3.0; x < 3.0; x += 0.05) EXPECT_EQ(cell_at(map, x + 0.01, 0.52), 97) << x;
}

TEST(OccupancyGrid, AWallIsOneCellThick) {
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {6.05, 4.05});
  auto random = test::seeded_random();
  OccupancyGrid grid;
  for (double x = -2.0; x < 2.0; x += 0.3) {
    const Pose2 pose(x, 0.3 * x, x);
    grid.add(test::closed_scan(scene, pose, 1440, 0.0, random), pose);
  }
  const GridMap map = trinary(grid.rasterise());
  for (double x = -2.9; x < 2.9; x += 0.05) {
    EXPECT_EQ(cell_at(map, x, 2.025), 100) << x;
    EXPECT_EQ(cell_at(map, x, 1.975), 0) << x;
    EXPECT_EQ(cell_at(map, x, 2.075), kUnknownCell) << x;
    EXPECT_EQ(cell_at(map, x, -2.025), 100) << x;
  }
}

TEST(OccupancyGrid, IsTheSameInAnyOrderBelowItsLimits) {
  const Scene scene = test::room_with_pillar();
  auto random = test::seeded_random();
  const Pose2 near(-0.4, -0.3, 0.5);
  const Pose2 far(0.2, -0.5, 2.0);
  const LaserScan first = test::closed_scan(scene, near, 720, 0.01, random);
  const LaserScan second = test::closed_scan(scene, far, 720, 0.01, random);
  const GridMap forward = build_occupancy_grid({{&first, near}, {&second, far}});
  const GridMap backward = build_occupancy_grid({{&second, far}, {&first, near}});
  EXPECT_EQ(forward.cells, backward.cells);
  EXPECT_GT(std::count(forward.cells.begin(), forward.cells.end(), 80), 100);
}

}  // namespace
}  // namespace falko_slam
