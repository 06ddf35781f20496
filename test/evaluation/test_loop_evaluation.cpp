// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_evaluation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/drives.hpp"

namespace falko_slam {
namespace {

TEST(EvaluateLoops, RunsEveryMethodAskedForUnderEveryProtocol) {
  auto random = test::seeded_random();
  const auto scans =
      test::drive(office_scene(), test::straight({-8.0, -1.0, 0.0}, 3.0, 0.5), random);
  LoopEvaluationParams params;
  params.protocols = {LoopProtocol::kOffline, LoopProtocol::kRevisits};
  params.methods = {"falko_slam", "GLAROT-RANSAC"};
  std::vector<std::string> told;
  const auto evaluation =
      evaluate_loops(scans, params, [&](const std::string& what) { told.push_back(what); });
  ASSERT_EQ(evaluation.methods.size(), 4U);
  EXPECT_EQ(evaluation.methods[0].method, "GLAROT-RANSAC");
  EXPECT_EQ(evaluation.methods[1].method, "falko_slam");
  EXPECT_EQ(evaluation.methods[1].protocol, LoopProtocol::kOffline);
  EXPECT_EQ(evaluation.methods[3].protocol, LoopProtocol::kRevisits);
  EXPECT_TRUE(evaluation.kidnapped.has_value());
  EXPECT_FALSE(told.empty());
}

TEST(EvaluateLoops, NamesTheMethodsThatAreKnown) {
  LoopEvaluationParams params;
  params.methods = {"SIFT"};
  try {
    evaluate_loops({}, params, [](const std::string&) {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("methods: \"SIFT\" is not one of"), std::string::npos) << text;
    for (const std::string& name : loop_method_names()) {
      EXPECT_NE(text.find(name), std::string::npos) << name;
    }
  }
}

TEST(EvaluateLoops, WantsAMethod) {
  LoopEvaluationParams params;
  params.methods.clear();
  EXPECT_THROW(validate(params), std::invalid_argument);
  EXPECT_NO_THROW(validate(LoopEvaluationParams()));
}

}  // namespace
}  // namespace falko_slam
