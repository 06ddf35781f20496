// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/loop_scores.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// Of 100 points of 0.1 m.
Agreement shares(std::size_t agreeing, std::size_t missed, std::size_t seen_through) {
  const auto length = [](std::size_t points) { return 0.1 * static_cast<double>(points); };
  return {100,         agreeing,         missed,         seen_through,
          length(100), length(agreeing), length(missed), length(seen_through)};
}

Agreement random_shares(std::mt19937_64& random) {
  const std::size_t agreeing = random() % 101;
  const std::size_t missed = random() % (101 - agreeing);
  return shares(agreeing, missed, random() % (101 - agreeing - missed));
}

TEST(ScanScore, IsBetweenZeroAndOne) {
  auto random = test::seeded_random();
  for (int run = 0; run < 1000; ++run) {
    const double score =
        scan_score(random_shares(random), random_shares(random), test::uniform(random, -0.1, 1.1));
    EXPECT_GE(score, 0.0);
    EXPECT_LE(score, 1.0);
  }
}

TEST(ScanScore, IsOneWhereAllAgrees) {
  EXPECT_DOUBLE_EQ(scan_score(shares(100, 0, 0), shares(100, 0, 0), 1.0), 1.0);
}

TEST(ScanScore, IsZeroWhereNothingAgreesOrIsInView) {
  EXPECT_EQ(scan_score(shares(0, 50, 50), shares(0, 50, 50), 1.0), 0.0);
  EXPECT_EQ(scan_score(shares(0, 0, 0), shares(0, 0, 0), 1.0), 0.0);
  EXPECT_EQ(scan_score({}, {}, 1.0), 0.0);
}

TEST(ScanScore, GrowsWithWhatAgrees) {
  const Agreement other = shares(50, 30, 20);
  for (const bool swapped : {false, true}) {
    double last = -1.0;
    for (std::size_t agreeing = 0; agreeing <= 100; agreeing += 5) {
      const Agreement one = shares(agreeing, 100 - agreeing, 0);
      const double score = swapped ? scan_score(other, one, 1.0) : scan_score(one, other, 1.0);
      EXPECT_GE(score, last);
      last = score;
    }
    EXPECT_GT(last, 0.5);
  }
}

TEST(ScanScore, IsLoweredByACorridor) {
  const Agreement all = shares(100, 0, 0);
  EXPECT_EQ(scan_score(all, all, 0.0), 0.0);
  EXPECT_LT(scan_score(all, all, 0.05), scan_score(all, all, 0.1));
  EXPECT_EQ(scan_score(all, all, 0.1), scan_score(all, all, 1.0));
}

TEST(ScanScore, IsLoweredWhereLittleIsInView) {
  EXPECT_LT(scan_score(shares(20, 0, 0), shares(20, 0, 0), 1.0),
            scan_score(shares(60, 0, 0), shares(60, 0, 0), 1.0));
}

TEST(ScanScore, TakesTheLesserDirection) {
  const Agreement good = shares(100, 0, 0);
  EXPECT_EQ(scan_score(good, shares(0, 100, 0), 1.0), 0.0);
  EXPECT_EQ(scan_score(shares(40, 60, 0), good, 1.0), scan_score(good, shares(40, 60, 0), 1.0));
}

TEST(NeighborhoodScore, GrowsWithWhatAgreesUpToTheScanScore) {
  double last = -1.0;
  for (std::size_t agreeing = 0; agreeing <= 100; agreeing += 5) {
    const double score = neighborhood_score(0.8, shares(agreeing, 100 - agreeing, 0));
    EXPECT_GE(score, last);
    last = score;
  }
  EXPECT_DOUBLE_EQ(last, 0.8);
}

TEST(NeighborhoodScore, IsZeroWithoutNeighbors) { EXPECT_EQ(neighborhood_score(1.0, {}), 0.0); }

// Keyframes of the room along a line, as they lie about the one in the middle.
class NeighborhoodAgreement : public ::testing::Test {
 protected:
  Neighborhood around(double y) {
    Neighborhood result;
    for (const double x : {0.0, -0.6, 0.6}) {
      const Pose2 pose(x - 1.0, y, 0.2);
      keyframes_.push_back(std::make_unique<Keyframe>());
      keyframes_.back()->view =
          ScanView(test::closed_scan(test::room_with_pillar(), pose, 360, 0.01, random_));
      const Pose2 center(-1.0, y, 0.2);
      result.members.push_back({keyframes_.back().get(), center.inverse() * pose});
    }
    return result;
  }

  std::mt19937_64 random_ = test::seeded_random();
  std::vector<std::unique_ptr<Keyframe>> keyframes_;
};

TEST_F(NeighborhoodAgreement, IsHighAtTheTruePoseAndLowBesideIt) {
  const Neighborhood target = around(0.0);
  const Neighborhood source = around(-0.4);
  const Pose2 truth = Pose2(-1.0, 0.0, 0.2).inverse() * Pose2(-1.0, -0.4, 0.2);
  EXPECT_GT(neighborhood_agreement(target, source, truth).ratio(), 0.9);
  EXPECT_LT(neighborhood_agreement(target, source, truth * Pose2(0.4, 0.4, 0.3)).ratio(), 0.5);
}

TEST_F(NeighborhoodAgreement, LeavesTheCentersOut) {
  Neighborhood target = around(0.0);
  Neighborhood source = around(0.0);
  target.members.resize(1);
  source.members.resize(1);
  EXPECT_EQ(neighborhood_agreement(target, source, {}).points, 0U);
}

TEST_F(NeighborhoodAgreement, CountsTheNeighborsOfBothSides) {
  const Neighborhood target = around(0.0);
  Neighborhood source = around(0.0);
  const std::size_t both = neighborhood_agreement(target, source, {}).points;
  source.members.resize(1);
  const std::size_t one = neighborhood_agreement(target, source, {}).points;
  EXPECT_GT(one, 0U);
  EXPECT_GT(both, one);
}

}  // namespace
}  // namespace falko_slam
