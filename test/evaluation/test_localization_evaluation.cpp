// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/localization_evaluation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/evaluation/kidnap_evaluation.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// Half a minute of the warehouse, with a map without errors.
class LocalizationEvaluation : public ::testing::Test {
 protected:
  LocalizationEvaluation() {
    const Scenario scenario =
        read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/warehouse.yaml");
    drive_ = simulate_drive(scenario, {}, {}, 1, 30.0);
    auto random = test::seeded_random();
    map_ = surveyed_map(scenario.world, 0.0, random);
  }

  SimulatedDrive drive_;
  LandmarkMap map_;
};

TEST_F(LocalizationEvaluation, ComparesEveryPoseWithTheTruth) {
  const LocalizationRun run = evaluate_localization(drive_, {}, map_);
  EXPECT_GT(run.scans, 200U);
  EXPECT_EQ(run.posed, run.scans);
  EXPECT_LT(run.position_rmse, 0.03);
  EXPECT_GE(run.position_max, run.position_rmse);
  EXPECT_EQ(run.wrong_ok, 0U);

  const RightPose nothing_is_right{1e-9, 1e-9};
  EXPECT_GT(evaluate_localization(drive_, {}, map_, nothing_is_right).wrong_ok, 0U);
}

TEST_F(LocalizationEvaluation, TimesTheWayBackFromAKidnap) {
  KidnapParams params;
  params.count = 2;
  params.before = 2.0;
  params.after = 10.0;
  const std::vector<Kidnap> kidnaps = evaluate_kidnaps(drive_, drive_, {}, map_, params);
  ASSERT_EQ(kidnaps.size(), 2U);
  for (const Kidnap& kidnap : kidnaps) {
    EXPECT_GE((kidnap.from.translation() - kidnap.to.translation()).norm(), params.least);
    EXPECT_GE(kidnap.lost, 0.0);
    EXPECT_TRUE(kidnap.ok < 0.0 || kidnap.ok >= kidnap.pose);
  }
  params.least = 1000.0;
  EXPECT_THROW(evaluate_kidnaps(drive_, drive_, {}, map_, params), std::invalid_argument);
  params.count = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
