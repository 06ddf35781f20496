// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using Cell = std::pair<int, int>;
using Marks = std::map<Cell, int>;

Marks marks_of(const ScanFootprint& seen) {
  Marks marks;
  for (std::int32_t row = 0; row < seen.height; ++row) {
    for (std::int32_t column = 0; column < seen.width; ++column) {
      const int mark = seen.marks[static_cast<std::size_t>(row * seen.width + column)];
      if (mark != 0) marks[{column + seen.column, row + seen.row}] = mark;
    }
  }
  return marks;
}

// Whether the segment crosses the open square of the cell, by clipping it at the four sides.
bool crosses(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Cell& cell) {
  double enters = 0.0;
  double leaves = 1.0;
  const double low[] = {static_cast<double>(cell.first), static_cast<double>(cell.second)};
  for (int axis = 0; axis < 2; ++axis) {
    const double way = to[axis] - from[axis];
    if (way == 0.0) {
      if (from[axis] <= low[axis] || from[axis] >= low[axis] + 1.0) return false;
      continue;
    }
    const double first = (low[axis] - from[axis]) / way;
    const double second = (low[axis] + 1.0 - from[axis]) / way;
    enters = std::max(enters, std::min(first, second));
    leaves = std::min(leaves, std::max(first, second));
  }
  return enters < leaves;
}

// The middle of the 1/1024 of a cell in which the point lies, in cells.
Eigen::Vector2d rounded(const Eigen::Vector2d& point, double resolution) {
  return ((point * (1024.0 / resolution)).array().floor() + 0.5) / 1024.0;
}

Marks by_brute_force(const LaserScan& scan, const Pose2& map_T_laser,
                     const OccupancyGridParams& params) {
  Marks marks;
  const Eigen::Vector2d laser = rounded(map_T_laser.translation(), params.resolution);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector2d end = rounded(map_T_laser * scan.point(i), params.resolution);
    const Cell last(static_cast<int>(std::floor(end.x())), static_cast<int>(std::floor(end.y())));
    for (int x = static_cast<int>(std::floor(std::min(laser.x(), end.x())));
         x <= std::max(laser.x(), end.x()); ++x) {
      for (int y = static_cast<int>(std::floor(std::min(laser.y(), end.y())));
           y <= std::max(laser.y(), end.y()); ++y) {
        if (Cell(x, y) != last && crosses(laser, end, {x, y})) {
          marks[{x, y}] |= ScanFootprint::kPassed;
        }
      }
    }
    marks[last] |= ScanFootprint::kHit;
  }
  return marks;
}

LaserScan random_scan(std::mt19937_64& random) {
  std::vector<double> ranges;
  for (int i = 0; i < 40; ++i) ranges.push_back(test::uniform(random, 0.01, 4.0));
  return test::circle_of(ranges);
}

Pose2 random_pose(std::mt19937_64& random) {
  const double x = test::uniform(random, -3.0, 3.0);
  const double y = test::uniform(random, -3.0, 3.0);
  return {x, y, test::uniform(random, -kPi, kPi)};
}

TEST(ScanFootprint, IsWhatBruteForceFinds) {
  auto random = test::seeded_random();
  OccupancyGridParams params;
  for (const double resolution : {0.05, 0.13, 1.0}) {
    params.resolution = resolution;
    for (int i = 0; i < 20; ++i) {
      const LaserScan scan = random_scan(random);
      const Pose2 pose = random_pose(random);
      EXPECT_EQ(marks_of(trace_scan(scan, pose, params)), by_brute_force(scan, pose, params));
    }
  }
}

TEST(ScanFootprint, TurnsWithTheScanByRightAngles) {
  auto random = test::seeded_random();
  const OccupancyGridParams params;
  for (int i = 0; i < 20; ++i) {
    const LaserScan scan = random_scan(random);
    const Pose2 pose = random_pose(random);
    const Pose2 turned(-pose.y(), pose.x(), pose.theta() + 0.5 * kPi);
    Marks expected;
    for (const auto& [cell, mark] : marks_of(trace_scan(scan, pose, params))) {
      expected[{-cell.second - 1, cell.first}] = mark;
    }
    EXPECT_EQ(marks_of(trace_scan(scan, turned, params)), expected);
  }
}

// Beams along the axes and diagonals of the grid, from a corner of a cell.
TEST(ScanFootprint, BeamsAlongBordersStayInTheirRectangle) {
  const OccupancyGridParams params;
  const LaserScan scan = test::round_scan(2.0, 8);
  for (const Pose2& pose : {Pose2(), Pose2(0.05, -0.1, 0.0), Pose2(0.025, 0.025, 0.25 * kPi)}) {
    const ScanFootprint seen = trace_scan(scan, pose, params);
    EXPECT_LE(seen.width, 82);
    EXPECT_LE(seen.height, 82);
    const auto hits = std::count_if(seen.marks.begin(), seen.marks.end(), [](std::uint8_t mark) {
      return (mark & ScanFootprint::kHit) != 0;
    });
    EXPECT_EQ(hits, 8);
  }
}

TEST(ScanFootprint, ABeamWithinOneCellHitsIt) {
  const LaserScan scan = test::scan_of({0.01}, 0.0, 0.0);
  EXPECT_EQ(marks_of(trace_scan(scan, {0.02, 0.02, 0.0}, {})),
            (Marks{{{0, 0}, ScanFootprint::kHit}}));
}

TEST(ScanFootprint, IsEmptyWithoutBeams) {
  EXPECT_TRUE(trace_scan({}, {}, {}).marks.empty());
  EXPECT_TRUE(
      trace_scan(test::scan_of({test::kNoRange, 0.0, -1.0}, 0.0, 0.1), {}, {}).marks.empty());
}

}  // namespace
}  // namespace falko_slam
