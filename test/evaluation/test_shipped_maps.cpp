// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// config/maps against the scenarios that they are of.
#include <gtest/gtest.h>

#include <string>

#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

TEST(ShippedMaps, HoldTheReflectorsOfTheirScenarios) {
  const std::string config = FALKO_SLAM_SOURCE_DIR "/config/";
  for (const std::string name : {"block_storage", "warehouse"}) {
    std::mt19937_64 random = test::seeded_random();
    const Scenario scenario = read_scenario(config + "scenarios/" + name + ".yaml");
    const LandmarkMap surveyed = surveyed_map(scenario.world, 0.0, random);

    const LandmarkMap shipped = read_landmark_map(config + "maps/" + name + ".yaml");

    ASSERT_EQ(shipped.landmarks.size(), surveyed.landmarks.size()) << name;
    for (std::size_t i = 0; i < shipped.landmarks.size(); ++i) {
      const MapLandmark& landmark = shipped.landmarks[i];
      EXPECT_EQ(landmark.id, surveyed.landmarks[i].id) << name;
      EXPECT_LT((landmark.position - surveyed.landmarks[i].position).norm(), 1e-9) << name << i;
      EXPECT_FALSE(landmark.covariance.isZero(0.0)) << name << i;
    }
  }
}

}  // namespace
}  // namespace falko_slam
