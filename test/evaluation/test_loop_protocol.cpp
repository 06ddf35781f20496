// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_protocol.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

std::vector<PosedScan> at(const std::vector<Pose2>& poses) {
  std::vector<PosedScan> scans;
  for (const Pose2& pose : poses) scans.push_back({{}, pose});
  return scans;
}

// Away by 6 m and back to the start.
const std::vector<Pose2> kThereAndBack = {
    {0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, {3.0, 0.5, 0.0}, {0.1, 0.0, 0.3}};

TEST(LoopTruth, OfflineAdmitsAllOthers) {
  const LoopTruth truth(at(kThereAndBack), LoopProtocol::kOffline);
  for (std::size_t source = 0; source < 5; ++source) {
    for (std::size_t target = 0; target < 5; ++target) {
      EXPECT_EQ(truth.admits(source, target), source != target);
    }
  }
  // 0 and 4, 1 and 3 are near each other; nothing is near 2.
  EXPECT_TRUE(truth.has_loop(0));
  EXPECT_FALSE(truth.has_loop(2));
  EXPECT_EQ(truth.loops(), 4U);
  EXPECT_EQ(truth.scans(), 5U);
}

TEST(LoopTruth, OnlineAdmitsEarlierOnesElsewhere) {
  const LoopTruth truth(at({{0.0, 0.0, 0.0},
                            {0.15, 0.15, 0.3},
                            {0.25, 0.0, 0.0},
                            {0.0, 0.25, 0.0},
                            {0.0, 0.0, 0.4},
                            {0.0, 0.0, -3.1},
                            {0.0, 0.0, 3.1}}),
                        LoopProtocol::kOnline);
  EXPECT_FALSE(truth.admits(0, 1));  // later
  EXPECT_FALSE(truth.admits(0, 0));
  EXPECT_FALSE(truth.admits(1, 0));  // the same place
  EXPECT_TRUE(truth.admits(2, 0));   // another x
  EXPECT_TRUE(truth.admits(3, 0));   // another y
  EXPECT_TRUE(truth.admits(4, 0));   // another heading
  EXPECT_FALSE(truth.admits(6, 5));  // headings on both sides of pi
}

TEST(LoopTruth, RevisitsAdmitsEarlierOnesFarBackOnTheWay) {
  const LoopTruth truth(at(kThereAndBack), LoopProtocol::kRevisits);
  EXPECT_TRUE(truth.admits(4, 0));   // some 12 m
  EXPECT_FALSE(truth.admits(4, 1));  // some 9 m
  EXPECT_FALSE(truth.admits(0, 4));  // later
  EXPECT_EQ(truth.loops(), 1U);
  EXPECT_TRUE(truth.has_loop(4));
}

TEST(LoopTruth, KidnappedAdmitsWhatIsFarOnTheWayBothBackAndAhead) {
  const LoopTruth truth(at(kThereAndBack), LoopProtocol::kKidnapped);
  EXPECT_TRUE(truth.admits(4, 0));
  EXPECT_TRUE(truth.admits(0, 4));
  EXPECT_FALSE(truth.admits(4, 1));
  EXPECT_FALSE(truth.admits(1, 4));
  EXPECT_FALSE(truth.admits(2, 2));
  EXPECT_EQ(truth.loops(), 2U);
  EXPECT_TRUE(truth.has_loop(0));
  EXPECT_TRUE(truth.has_loop(4));
  EXPECT_EQ(truth.protocol(), LoopProtocol::kKidnapped);
}

TEST(LoopTruth, ALoopIsNearAndTurnedLittle) {
  const LoopProtocolParams params;
  const auto has_loop = [&](const Pose2& second) {
    return LoopTruth(at({{}, second}), LoopProtocol::kOffline, params).has_loop(1);
  };
  EXPECT_TRUE(has_loop({params.loop_distance - 0.01, 0.0, 0.0}));
  EXPECT_FALSE(has_loop({params.loop_distance + 0.01, 0.0, 0.0}));
  EXPECT_TRUE(has_loop({0.0, 0.0, params.loop_turn - 0.01}));
  EXPECT_FALSE(has_loop({0.0, 0.0, -params.loop_turn - 0.01}));
}

TEST(LoopTruth, AClosureIsRightWithinItsErrors) {
  const LoopProtocolParams params;
  const std::vector<Pose2> poses = {{1.0, 2.0, 2.0}, {1.5, 1.0, -2.5}};
  const LoopTruth truth(at(poses), LoopProtocol::kOffline, params);
  const Pose2 target_T_source = poses[0].inverse() * poses[1];
  EXPECT_TRUE(truth.is_right(1, 0, target_T_source));
  EXPECT_FALSE(truth.is_right(0, 1, target_T_source));
  for (const double side : {-1.0, 1.0}) {
    const double inside = side * 0.99;
    const double outside = side * 1.01;
    EXPECT_TRUE(truth.is_right(1, 0, target_T_source * Pose2(0.0, inside * params.max_error, 0.0)));
    EXPECT_FALSE(
        truth.is_right(1, 0, target_T_source * Pose2(outside * params.max_error, 0.0, 0.0)));
    EXPECT_TRUE(
        truth.is_right(1, 0, target_T_source * Pose2(0.0, 0.0, inside * params.max_turn_error)));
    EXPECT_FALSE(
        truth.is_right(1, 0, target_T_source * Pose2(0.0, 0.0, outside * params.max_turn_error)));
  }
}

TEST(LoopTruth, OfNoScansHasNoLoops) {
  EXPECT_EQ(LoopTruth({}, LoopProtocol::kOnline).loops(), 0U);
}

// closed, score, right, has_loop
const std::vector<LoopAnswer> kAnswers = {{true, 0.9, true, true},   {true, 0.8, false, true},
                                          {true, 0.7, true, false},  {true, 0.7, false, false},
                                          {false, 0.0, false, true}, {false, 0.0, false, false}};

TEST(LoopOperatingPoint, CountsClosuresOfAtLeastTheScore) {
  const LoopOperatingPoint point = operating_point(kAnswers, 0.7);
  EXPECT_EQ(point.closures, 4U);
  EXPECT_EQ(point.wrong, 2U);
  EXPECT_EQ(point.precision, 2.0 / 4.0);
  EXPECT_EQ(point.recall, 1.0 / 3.0);
}

TEST(LoopOperatingPoint, IsPreciseWhereNothingIsClosed) {
  for (const LoopOperatingPoint& point : {operating_point(kAnswers, 1.0), operating_point({}, 0)}) {
    EXPECT_EQ(point.closures, 0U);
    EXPECT_EQ(point.precision, 1.0);
    EXPECT_EQ(point.recall, 0.0);
  }
}

TEST(LoopCurve, HasAPointForEveryScore) {
  const auto curve = loop_curve(kAnswers);
  ASSERT_EQ(curve.size(), 3U);
  const std::vector<std::size_t> closures = {1, 2, 4};
  const std::vector<double> scores = {0.9, 0.8, 0.7};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_EQ(curve[i].min_score, scores[i]);
    EXPECT_EQ(curve[i].closures, closures[i]);
  }
  EXPECT_TRUE(loop_curve({}).empty());
}

std::vector<LoopAnswer> random_answers(std::mt19937_64& random) {
  std::vector<LoopAnswer> answers(40);
  for (LoopAnswer& answer : answers) {
    answer.closed = random() % 4 != 0;
    answer.has_loop = random() % 3 != 0;
    answer.score = answer.closed ? static_cast<double>(random() % 15) : 0.0;
    // The surer, the righter.
    answer.right = answer.closed && test::uniform(random, 0.0, 8.0) < answer.score;
  }
  return answers;
}

// Straight from the answers: counts for one threshold.
struct Counts {
  double closures = 0.0, right = 0.0, found = 0.0, loops = 0.0;

  Counts(const std::vector<LoopAnswer>& answers, double threshold) {
    for (const LoopAnswer& answer : answers) {
      const bool closed = answer.closed && answer.score >= threshold;
      closures += closed ? 1.0 : 0.0;
      right += closed && answer.right ? 1.0 : 0.0;
      found += closed && answer.right && answer.has_loop ? 1.0 : 0.0;
      loops += answer.has_loop ? 1.0 : 0.0;
    }
  }
  double precision() const { return right / closures; }
  double recall() const { return found / loops; }
};

TEST(LoopSummary, IsWhatTryingAllThresholdsFinds) {
  auto random = test::seeded_random();
  std::size_t broke_even = 0;
  for (int run = 0; run < 200; ++run) {
    const auto answers = random_answers(random);
    LoopSummary expected;
    bool fallen = false;
    for (int threshold = 14; threshold >= 0; --threshold) {
      const Counts counts(answers, threshold);
      if (counts.closures == 0.0) continue;
      const double precision = counts.precision();
      const double recall = counts.recall();
      if (precision == 1.0) expected.recall_at_100 = std::max(expected.recall_at_100, recall);
      if (precision >= 0.95) expected.recall_at_95 = std::max(expected.recall_at_95, recall);
      if (precision + recall > 0.0) {
        expected.f1 = std::max(expected.f1, 2.0 * precision * recall / (precision + recall));
      }
      if (!fallen && recall > 0.0 && precision <= recall) {
        fallen = true;
        expected.break_even = recall;
      }
    }
    broke_even += fallen ? 1U : 0U;
    const LoopSummary found = summarize(loop_curve(answers));
    EXPECT_DOUBLE_EQ(found.recall_at_100, expected.recall_at_100);
    EXPECT_DOUBLE_EQ(found.recall_at_95, expected.recall_at_95);
    EXPECT_DOUBLE_EQ(found.f1, expected.f1);
    EXPECT_DOUBLE_EQ(found.break_even, expected.break_even);
  }
  EXPECT_GT(broke_even, 0U);
}

TEST(LoopSummary, OfNothingIsZero) {
  const LoopSummary summary = summarize({});
  EXPECT_EQ(summary.break_even, 0.0);
  EXPECT_EQ(summary.recall_at_100, 0.0);
  EXPECT_EQ(summary.f1, 0.0);
}

}  // namespace
}  // namespace falko_slam
