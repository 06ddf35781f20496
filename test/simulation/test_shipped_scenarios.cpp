// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
// config/scenarios: all of them load and are what their readers are told.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "falko_slam/simulation/scenario_file.hpp"

namespace falko_slam {
namespace {

constexpr char kFolder[] = FALKO_SLAM_SOURCE_DIR "/config/scenarios";

Scenario shipped(const std::string& name) {
  return read_scenario(std::string(kFolder) + "/" + name + ".yaml");
}

// The fixed ones.
std::size_t reflectors_of(const Scenario& scenario) {
  const auto& cylinders = scenario.world.fixed.cylinders;
  return static_cast<std::size_t>(
      std::count_if(cylinders.begin(), cylinders.end(), [&](const Cylinder& cylinder) {
        return scenario.world.surfaces[cylinder.surface].retro_gain > 0.0;
      }));
}

Eigen::AlignedBox2d bounds_of(const World& world) {
  Eigen::AlignedBox2d bounds;
  for (const Face& face : world.fixed.faces) bounds.extend(face.from).extend(face.to);
  return bounds;
}

std::vector<Eigen::Vector2d> places_of(const Scenario& scenario) {
  std::vector<Eigen::Vector2d> places = {scenario.world_T_start.translation()};
  for (const DriveStep& step : scenario.drive) {
    const auto* follow = std::get_if<FollowStep>(&step);
    if (follow != nullptr)
      places.insert(places.end(), follow->through.begin(), follow->through.end());
  }
  return places;
}

// From corner to corner, without regard to their rounding [m].
std::vector<double> backward_ways_of(const Scenario& scenario) {
  std::vector<double> ways;
  Eigen::Vector2d here = scenario.world_T_start.translation();
  for (const DriveStep& step : scenario.drive) {
    const auto* follow = std::get_if<FollowStep>(&step);
    if (follow == nullptr) continue;
    double way = 0.0;
    for (const Eigen::Vector2d& point : follow->through) {
      way += (point - here).norm();
      here = point;
    }
    if (follow->backward) ways.push_back(way);
  }
  return ways;
}

TEST(ShippedScenarios, AreNamedLikeTheirFilesAndDriveInTheirWorlds) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const Scenario scenario = read_scenario(entry.path().string());
    EXPECT_EQ(scenario.name, entry.path().stem());
    const bool of_recordings = scenario.name == "front_tricycle";
    EXPECT_EQ(scenario.drive.empty(), of_recordings) << scenario.name;
    const Eigen::AlignedBox2d bounds = bounds_of(scenario.world);
    for (const Eigen::Vector2d& place : places_of(scenario)) {
      EXPECT_TRUE(bounds.contains(place)) << scenario.name << ": " << place.transpose();
    }
    for (const Cylinder& cylinder : scenario.world.fixed.cylinders) {
      EXPECT_TRUE(bounds.contains(cylinder.center)) << scenario.name;
    }
    ++count;
  }
  EXPECT_EQ(count, 5U);
}

TEST(ShippedScenarios, WarehouseHasReflectorsAndThingsThatMove) {
  const Scenario scenario = shipped("warehouse");
  EXPECT_EQ(bounds_of(scenario.world).sizes(), Eigen::Vector2d(60.0, 40.0));
  EXPECT_GE(reflectors_of(scenario), 20U);
  EXPECT_LE(reflectors_of(scenario), 30U);
  const auto& bodies = scenario.world.bodies;
  EXPECT_EQ(std::count_if(bodies.begin(), bodies.end(),
                          [](const Body& body) { return body.motion.through.size() > 1; }),
            3);
}

TEST(ShippedScenarios, BlockStorageHasThePathsOfTable56) {
  const std::vector<double> ways = backward_ways_of(shipped("block_storage"));
  ASSERT_EQ(ways.size(), 6U);  // two of them lead to where a path begins
  EXPECT_NEAR(ways[0], 12.0, 1e-9);
  EXPECT_NEAR(ways[1], 12.0, 0.1);  // its corner is cut
  EXPECT_NEAR(ways[3], 12.0, 1e-9);
  EXPECT_NEAR(ways[5], 7.0, 1e-9);
}

TEST(ShippedScenarios, CalibrationAreaHasFourPhasesOfSixHalfCircles) {
  const Scenario scenario = shipped("calibration_area");
  EXPECT_GE(reflectors_of(scenario), 10U);
  EXPECT_LE(reflectors_of(scenario), 12U);
  std::vector<ArcStep> arcs;
  for (const DriveStep& step : scenario.drive) {
    if (const auto* arc = std::get_if<ArcStep>(&step)) arcs.push_back(*arc);
  }
  ASSERT_EQ(arcs.size(), 24U);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    EXPECT_NEAR(arcs[i].turn, kPi, 1e-12);
    EXPECT_EQ(arcs[i].wheel_speed, i < 12 ? 1.0 : -1.0);
    EXPECT_EQ(arcs[i].steering > 0.0, i % 12 < 6);
    const double share = static_cast<double>(i % 6) / 5.0;
    EXPECT_NEAR(std::abs(arcs[i].steering), degrees_to_radians(18.0 + 32.0 * share), 1e-12);
  }
}

// The ideal tricycle comes back to where it began.
TEST(ShippedScenarios, CalibrationAreaIsNotLeft) {
  const Scenario scenario = shipped("calibration_area");
  Pose2 pose = scenario.world_T_start;
  for (const DriveStep& step : scenario.drive) {
    const auto* arc = std::get_if<ArcStep>(&step);
    if (arc == nullptr) continue;
    const double radius = 1.358 / std::tan(arc->steering);
    const double turn = std::copysign(arc->turn, radius * arc->wheel_speed);
    pose = pose * Pose2::exp({radius * turn, 0.0, turn});
    EXPECT_LT(pose.translation().norm(), 7.0);
  }
  EXPECT_LT((pose.translation() - scenario.world_T_start.translation()).norm(), 1e-9);
}

TEST(ShippedScenarios, OfficeLoopComesByItsPlacesAgain) {
  const Scenario scenario = shipped("office_loop");
  EXPECT_EQ(bounds_of(scenario.world).sizes(), Eigen::Vector2d(40.0, 25.0));
  const auto places = places_of(scenario);
  std::size_t again = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    again +=
        std::count(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), places[i]) > 0;
  }
  EXPECT_GE(again, 8U);
}

}  // namespace
}  // namespace falko_slam
