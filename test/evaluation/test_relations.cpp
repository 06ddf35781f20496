// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/relations.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "support/seeds.hpp"
#include "support/temporary_folder.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using test::at_seconds;

Pose2 random_pose(std::mt19937_64& random) {
  const double x = test::uniform(random, -10.0, 10.0);
  const double y = test::uniform(random, -10.0, 10.0);
  return {x, y, test::uniform(random, -kPi, kPi)};
}

Eigen::Matrix3d matrix_of(const Pose2& pose) {
  Eigen::Matrix3d matrix;
  matrix << std::cos(pose.theta()), -std::sin(pose.theta()), pose.x(),  //
      std::sin(pose.theta()), std::cos(pose.theta()), pose.y(), 0.0, 0.0, 1.0;
  return matrix;
}

struct Drive {
  Trajectory trajectory;
  std::vector<Relation> relations;  // exact
};

Drive random_drive() {
  auto random = test::seeded_random();
  Drive drive;
  for (int i = 0; i < 50; ++i)
    drive.trajectory.push_back({at_seconds(0.1 * i), random_pose(random)});
  for (int i = 0; i < 100; ++i) {
    const StampedPose& a = drive.trajectory[random() % 50];
    const StampedPose& b = drive.trajectory[random() % 50];
    drive.relations.push_back({a.stamp, b.stamp, a.map_T_base.inverse() * b.map_T_base});
  }
  return drive;
}

TEST(Relations, ErrorsAreWhatAHandComputes) {
  const Trajectory trajectory = {{at_seconds(0.0), {1.0, 1.0, 0.5 * kPi}},
                                 {at_seconds(1.0), {1.0, 4.0, kPi}}};
  // Estimated: 3 m ahead and a quarter turn to the left. Said to be true: 0.4 m short and 0.3 m to
  // the right of that, 0.1 rad less.
  const auto result = evaluate_relations(
      trajectory, {{at_seconds(0.0), at_seconds(1.0), {2.6, -0.3, 0.5 * kPi - 0.1}}});
  ASSERT_EQ(result.errors.translation.size(), 1U);
  EXPECT_NEAR(result.errors.translation[0], 0.5, 1e-12);
  EXPECT_NEAR(result.errors.rotation[0], 0.1, 1e-12);
}

TEST(Relations, ErrorsAreThoseOfMatrices) {
  Drive drive = random_drive();
  auto random = test::seeded_random();
  for (Relation& relation : drive.relations) relation.first_T_second = random_pose(random);
  const auto result = evaluate_relations(drive.trajectory, drive.relations);
  ASSERT_EQ(result.errors.translation.size(), drive.relations.size());
  for (std::size_t i = 0; i < drive.relations.size(); ++i) {
    const Relation& relation = drive.relations[i];
    Eigen::Matrix3d first = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d second = first;
    for (const StampedPose& pose : drive.trajectory) {
      if (pose.stamp == relation.first) first = matrix_of(pose.map_T_base);
      if (pose.stamp == relation.second) second = matrix_of(pose.map_T_base);
    }
    const Eigen::Matrix3d error =
        matrix_of(relation.first_T_second).inverse() * first.inverse() * second;
    EXPECT_NEAR(result.errors.translation[i], std::hypot(error(0, 2), error(1, 2)), 1e-9);
    EXPECT_NEAR(result.errors.rotation[i], std::abs(std::atan2(error(1, 0), error(0, 0))), 1e-9);
  }
}

TEST(Relations, AnExactTrajectoryHasNoErrorWhereverItsMapLies) {
  Drive drive = random_drive();
  const Pose2 elsewhere(30.0, -7.0, 2.5);
  for (StampedPose& pose : drive.trajectory) pose.map_T_base = elsewhere * pose.map_T_base;
  const auto result = evaluate_relations(drive.trajectory, drive.relations);
  EXPECT_LT(summarise(result.errors.translation).max, 1e-9);
  EXPECT_LT(summarise(result.errors.rotation).max, 1e-9);
}

TEST(Relations, ThoseWithoutPosesAreCounted) {
  Drive drive = random_drive();
  drive.relations[3].first = at_seconds(1000.0);
  drive.relations[7].second = at_seconds(1000.0);
  const auto result = evaluate_relations(drive.trajectory, drive.relations);
  EXPECT_EQ(result.missing, 2U);
  EXPECT_EQ(result.compared.size(), 98U);
  EXPECT_EQ(result.errors.translation.size(), 98U);
}

TEST(Relations, NoneThatCanBeComparedIsAnError) {
  EXPECT_THROW(evaluate_relations({}, random_drive().relations), std::runtime_error);
  EXPECT_THROW(evaluate_relations(random_drive().trajectory, {}), std::runtime_error);
}

TEST(Relations, AreReadPlainAndPacked) {
  const test::TemporaryFolder folder;
  const std::string text =
      "# hand-checked\n976052905.167303 976052911.885496 -0.056990 -0.128430 0 0 0 -1.682210\n\n";
  for (const char* name : {"r", "r.gz", "r.bz2"}) {
    const auto relations = read_relations(folder.write(name, text));
    ASSERT_EQ(relations.size(), 1U);
    EXPECT_EQ(relations[0].first, *time_of("976052905.167303"));
    EXPECT_EQ(relations[0].second, *time_of("976052911.885496"));
    EXPECT_EQ(relations[0].first_T_second.x(), -0.05699);
    EXPECT_NEAR(relations[0].first_T_second.theta(), -1.68221, 1e-12);
  }
}

TEST(Relations, ErrorsOfTheFileNameItAndTheLine) {
  const test::TemporaryFolder folder;
  const auto error_of = [&](const std::string& text) {
    try {
      read_relations(folder.write("r", text));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of("# none\n"), folder.file("r") + ": holds no relation");
  EXPECT_EQ(error_of("1 2 0 0 0 0 0 0\n1 2 3\n").find(folder.file("r") + ": line 2: must be eight"),
            0U);
  EXPECT_EQ(error_of("x 2 0 0 0 0 0 0\n").find(folder.file("r") + ": line 1: 'x 2'"), 0U);
}

}  // namespace
}  // namespace falko_slam
