// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/thesis_methods.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/drives.hpp"
#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

class ThesisMethods : public ::testing::TestWithParam<std::string> {
 protected:
  static std::vector<PosedScan> corridor() {
    auto random = test::seeded_random();
    return test::drive(office_scene(), test::straight({-8.0, -1.0, 0.0}, 4.0, 0.2), random);
  }
};

TEST_P(ThesisMethods, CloseMostScansOfAShortWayRightly) {
  const auto scans = corridor();
  const LoopTruth truth(scans, LoopProtocol::kOffline);
  std::vector<LoopAnswer> answers;
  const auto result = run_method(thesis_method(GetParam(), scans), truth, answers);
  EXPECT_GT(result.summary.f1, 0.6);
  EXPECT_TRUE(result.detection.has_value());
  EXPECT_TRUE(result.search.has_value());
  EXPECT_TRUE(result.association.has_value());
}

TEST_P(ThesisMethods, ScoreByKeypointsWithANeighbour) {
  const auto scans = corridor();
  const LoopTruth truth(scans, LoopProtocol::kOffline);
  const LoopMethod method = thesis_method(GetParam(), scans);
  for (std::size_t source = 0; source < scans.size(); ++source) {
    const auto closure = method.close(source, truth).closure;
    if (!closure) continue;
    EXPECT_TRUE(truth.admits(source, closure->target));
    EXPECT_EQ(closure->score, std::floor(closure->score));
    EXPECT_GE(closure->score, 0.0);
  }
}

TEST_P(ThesisMethods, AnswerAScanTheSameWhateverCameBefore) {
  const auto scans = corridor();
  const LoopTruth truth(scans, LoopProtocol::kOffline);
  const LoopMethod first = thesis_method(GetParam(), scans);
  const LoopMethod second = thesis_method(GetParam(), scans);
  first.close(1, truth);
  const auto a = first.close(7, truth).closure;
  const auto b = second.close(7, truth).closure;
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->target, b->target);
  EXPECT_EQ(a->score, b->score);
}

TEST_P(ThesisMethods, CloseNothingWithoutKeypoints) {
  const std::vector<PosedScan> scans(3, {test::round_scan(5.0), {}});
  const LoopTruth truth(scans, LoopProtocol::kOffline);
  const LoopMethod method = thesis_method(GetParam(), scans);
  EXPECT_FALSE(method.close(1, truth).closure.has_value());
}

INSTANTIATE_TEST_SUITE_P(All, ThesisMethods, ::testing::ValuesIn(thesis_method_names()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           for (char& letter : name) letter = letter == '-' ? '_' : letter;
                           return name;
                         });

TEST(ThesisMethod, RefusesUnknownNames) {
  EXPECT_THROW(thesis_method("SIFT", {}), std::invalid_argument);
}

TEST(ThesisMethodParams, NameFieldAndValueOfWhatIsWrong) {
  ThesisMethodParams params;
  params.gfp_candidates = 0;
  try {
    thesis_method("GFP", {}, params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "gfp_candidates = 0: must be in [1, 1000]");
  }
}

TEST(ThesisMethod, OfNoScansIsEmpty) {
  for (const std::string& name : thesis_method_names()) {
    EXPECT_EQ(thesis_method(name, {}).creation.mean, 0.0) << name;
  }
}

}  // namespace
}  // namespace falko_slam
