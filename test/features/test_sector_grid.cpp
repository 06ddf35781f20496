// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/sector_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

int sector_by_atan2(int count, double x, double y) {
  const int sector = static_cast<int>(std::floor(count / kTwoPi * std::atan2(y, x)));
  return (sector + count) % count;
}

TEST(SectorGrid, IsFloorOfTheAngle) {
  auto random = test::seeded_random();
  for (const int count : {2, 3, 4, 7, 16, 64, 360, 1024}) {
    const SectorGrid grid(count);
    for (int i = 0; i < 20000; ++i) {
      const double angle = test::uniform(random, -kPi, kPi);
      const double length = test::uniform(random, 1e-6, 100.0);
      // Single precision cannot tell directions nearer than this to the border of a sector.
      const double in_sector = angle / (kTwoPi / count) - std::floor(angle / (kTwoPi / count));
      if (std::min(in_sector, 1.0 - in_sector) < 1e-6 * count) continue;
      const double x = length * std::cos(angle);
      const double y = length * std::sin(angle);
      EXPECT_EQ(grid.sector(static_cast<float>(x), static_cast<float>(y)),
                sector_by_atan2(count, x, y))
          << count << " " << angle;
    }
  }
}

TEST(SectorGrid, AxesBelongToTheSectorTheyStart) {
  const SectorGrid grid(16);
  EXPECT_EQ(grid.sector(1.0F, 0.0F), 0);
  EXPECT_EQ(grid.sector(0.0F, 1.0F), 4);
  EXPECT_EQ(grid.sector(-1.0F, 0.0F), 8);
  EXPECT_EQ(grid.sector(-1.0F, -0.0F), 8);
  EXPECT_EQ(grid.sector(0.0F, -1.0F), 12);
  EXPECT_EQ(grid.sector(1.0F, -1e-12F), 15);
}

TEST(SectorGrid, PutsTheZeroVectorIntoTheFirstSector) {
  EXPECT_EQ(SectorGrid(16).sector(0.0F, 0.0F), 0);
}

TEST(SectorGrid, RefusesSillyCounts) {
  EXPECT_THROW(SectorGrid(1), std::invalid_argument);
  EXPECT_THROW(SectorGrid(0), std::invalid_argument);
  EXPECT_THROW(SectorGrid(1025), std::invalid_argument);
}

// The thesis' own formula (3.7), with a modulo that is never negative.
TEST(SectorDistance, IsEquation3_7) {
  for (const int count : {2, 3, 16, 17}) {
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < count; ++b) {
        const double half = count / 2.0;
        double d = std::fmod(a - b + half, count);
        if (d < 0.0) d += count;
        EXPECT_EQ(sector_distance(a, b, count), static_cast<int>(std::abs(d - half)))
            << a << " " << b << " " << count;
      }
    }
  }
  EXPECT_EQ(sector_distance(0, 15, 16), 1);  // where C's % on negative numbers gives 15
}

TEST(SectorHistogram, SumsOverAllPairs) {
  auto random = test::seeded_random();
  constexpr int kSectors = 16;
  SectorHistogram histogram(kSectors);
  for (int run = 0; run < 200; ++run) {
    histogram.clear();
    std::vector<int> sectors;
    const int points = std::uniform_int_distribution<int>(0, 40)(random);
    for (int i = 0; i < points; ++i) {
      sectors.push_back(std::uniform_int_distribution<int>(0, kSectors - 1)(random));
      histogram.add(sectors.back());
    }
    long brute_force = 0;
    for (std::size_t i = 0; i < sectors.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        brute_force += sector_distance(sectors[i], sectors[j], kSectors);
      }
    }
    EXPECT_EQ(histogram.pairwise_distance(), brute_force);
  }
}

}  // namespace
}  // namespace falko_slam
