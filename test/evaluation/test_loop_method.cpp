// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_method.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

TEST(LoopTiming, IsMeanMedianAndPercentile) {
  std::vector<double> times;
  for (int i = 199; i >= 0; --i) times.push_back(i);
  const LoopTiming timing = loop_timing(times);
  EXPECT_DOUBLE_EQ(timing.mean, 99.5);
  EXPECT_DOUBLE_EQ(timing.median, 100.0);
  EXPECT_DOUBLE_EQ(timing.p99, 198.0);
}

TEST(LoopTiming, OfNothingIsZero) { EXPECT_EQ(loop_timing({}).p99, 0.0); }

// Four scans of one place; a method that closes each with the one before, the third one wrongly.
class RunMethod : public ::testing::Test {
 protected:
  RunMethod() {
    method_.name = "the one before";
    method_.close = [this](std::size_t source, const LoopTruth& truth) {
      EXPECT_TRUE(truth.admits(source, source + 1));
      if (source == 0) return LoopTrial{};
      const Pose2 pose(source == 2 ? 3.0 : 0.0, 0.0, 0.0);
      return LoopTrial{LoopClosure{source - 1, static_cast<double>(source), pose}, search_};
    };
  }

  LoopMethod method_;
  std::optional<double> search_ = 0.0;
  LoopTruth truth_ = LoopTruth(std::vector<PosedScan>(4), LoopProtocol::kOffline);
  std::vector<LoopAnswer> answers_;
};

TEST_F(RunMethod, JudgesEveryAnswer) {
  const LoopMethodResult result = run_method(method_, truth_, answers_);
  EXPECT_EQ(result.method, "the one before");
  EXPECT_EQ(result.protocol, LoopProtocol::kOffline);
  EXPECT_EQ(result.scans, 4U);
  EXPECT_EQ(result.loops, 4U);
  ASSERT_EQ(answers_.size(), 4U);
  EXPECT_FALSE(answers_[0].closed);
  EXPECT_TRUE(answers_[1].right);
  EXPECT_FALSE(answers_[2].right);
  EXPECT_EQ(answers_[3].score, 3.0);
  EXPECT_EQ(result.curve.size(), 3U);
  EXPECT_EQ(result.summary.recall_at_100, 0.25);
}

TEST_F(RunMethod, TimesItsPartsWhereItHasSome) {
  EXPECT_TRUE(run_method(method_, truth_, answers_).association.has_value());
  search_.reset();
  EXPECT_FALSE(run_method(method_, truth_, answers_).association.has_value());
}

}  // namespace
}  // namespace falko_slam
