// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Several drives in one map, and maps that outlive the process.
#include <gtest/gtest.h>

#include <stdexcept>

#include "support/slam_drives.hpp"

namespace falko_slam {
namespace {

// Two offices' length of the corridor, from where nobody knows.
test::SlamDrive another_drive(std::mt19937_64& random) {
  auto drive = test::slam_drive(office_scene(), test::straight({6.0, 1.0, kPi}, 12.0, 0.1), random);
  test::let_drift(drive, random);
  test::begin_odometry_at(drive, {100.0, -50.0, 2.0});
  return drive;
}

test::SlamDrive first_drive(std::mt19937_64& random) {
  auto drive = test::slam_drive(office_scene(), office_path(0.1), random);
  test::let_drift(drive, random);
  return drive;
}

// Corridors around a block, where no office is.
test::SlamDrive drive_elsewhere(std::mt19937_64& random) {
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {9.0, 31.0});
  scene.add_box({1.0, 3.0, 0.4}, {2.0, 7.0});
  scene.add_box({-2.0, -9.0, -0.3}, {1.0, 2.5});
  return test::slam_drive(scene, test::straight({-2.0, -5.0, 1.4}, 6.0, 0.1), random);
}

void expect_at_its_place(const FeatureSlam& slam, const std::vector<SlamStep>& steps,
                         const test::SlamDrive& drive) {
  EXPECT_FALSE(steps.front().anchored);
  EXPECT_TRUE(steps.back().anchored);
  EXPECT_TRUE(slam.anchored());
  EXPECT_LT(test::distance(steps.back().map_T_base, drive.back().world_T_base), 0.10);
  EXPECT_LT(test::greatest_error(slam, steps, drive), 0.10);
}

class SeveralDrives : public ::testing::Test {
 protected:
  void SetUp() override {
    test::run(slam_, first_drive(random_));
    slam_.finish();
  }

  std::mt19937_64 random_ = test::seeded_random();
  FeatureSlam slam_;
};

TEST_F(SeveralDrives, ASecondOneFindsItsPlace) {
  const auto drive = another_drive(random_);
  slam_.begin_drive();
  EXPECT_FALSE(slam_.anchored());
  const auto steps = test::run(slam_, drive);
  slam_.finish();
  expect_at_its_place(slam_, steps, drive);
}

TEST_F(SeveralDrives, OneWithoutOdometryFindsItsPlaceToo) {
  auto drive = another_drive(random_);
  test::forget_odometry(drive);
  slam_.begin_drive();
  const auto steps = test::run(slam_, drive);
  slam_.finish();
  expect_at_its_place(slam_, steps, drive);
}

TEST_F(SeveralDrives, AStateGoesOn) {
  const SlamState state = slam_.state();
  FeatureSlam next(SlamParams(), state);
  ASSERT_EQ(next.keyframes(), slam_.keyframes());
  for (std::size_t i = 0; i < next.keyframes(); ++i) {
    EXPECT_LT(test::distance(next.map_T_laser({i}), slam_.map_T_laser({i})), 1e-6) << i;
    EXPECT_TRUE(next.is_mapped({i})) << i;
  }
  EXPECT_FALSE(next.anchored());
  const auto drive = another_drive(random_);
  const auto steps = test::run(next, drive);
  next.finish();
  expect_at_its_place(next, steps, drive);
}

TEST_F(SeveralDrives, WhatIsNotAnchoredIsLeftOut) {
  const std::size_t first = slam_.keyframes();
  slam_.begin_drive();
  const auto lost = test::run(slam_, drive_elsewhere(random_));
  EXPECT_FALSE(lost.back().anchored);
  EXPECT_EQ(slam_.state().keyframes.size(), first);
  const std::size_t elsewhere = slam_.keyframes() - first;
  EXPECT_GT(elsewhere, 5U);
  EXPECT_FALSE(slam_.is_mapped({first}));

  slam_.begin_drive();
  test::run(slam_, another_drive(random_));
  ASSERT_TRUE(slam_.anchored());
  const SlamState state = slam_.state();
  ASSERT_EQ(state.keyframes.size(), slam_.keyframes() - elsewhere);
  ASSERT_EQ(state.graph.nodes.size(), state.keyframes.size());
  for (std::size_t i = 0; i < state.keyframes.size(); ++i) {
    EXPECT_EQ(state.keyframes[i].drive, i < first ? 0U : 1U) << i;
    EXPECT_EQ(state.graph.nodes[i].id.value, i);
  }
  for (const GraphConstraint& constraint : state.graph.constraints) {
    EXPECT_LT(constraint.from.value, state.keyframes.size());
    EXPECT_LT(constraint.to.value, state.keyframes.size());
  }
  const FeatureSlam again(SlamParams(), state);
  EXPECT_EQ(again.keyframes(), state.keyframes.size());
}

TEST_F(SeveralDrives, PartsOfAStateMustBelongTogether) {
  SlamState state = slam_.state();
  state.graph.nodes.pop_back();
  EXPECT_THROW(FeatureSlam(SlamParams(), state), std::invalid_argument);
  state = slam_.state();
  std::swap(state.graph.nodes[0], state.graph.nodes[1]);
  EXPECT_THROW(FeatureSlam(SlamParams(), state), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
