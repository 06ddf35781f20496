// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/feature_slam.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/slam/slam_params.hpp"
#include "support/hand_made_scans.hpp"
#include "support/slam_drives.hpp"

namespace falko_slam {
namespace {

// Twice around the office with an odometry that drifts by metres.
const test::SlamDrive& two_rounds() {
  static const test::SlamDrive drive = [] {
    auto random = test::seeded_random();
    auto result =
        test::slam_drive(office_scene(), test::joined(office_path(0.1), office_path(0.1)), random);
    test::let_drift(result, random);
    return result;
  }();
  return drive;
}

struct Run {
  FeatureSlam slam;
  std::vector<SlamStep> steps;
};

Run run_of(const test::SlamDrive& drive) {
  Run result;
  result.steps = test::run(result.slam, drive);
  result.slam.finish();
  return result;
}

const Run& run_of_two_rounds() {
  static const Run run = run_of(two_rounds());
  return run;
}

TEST(FeatureSlam, IsFarBetterThanTheOdometry) {
  const auto& [slam, steps] = run_of_two_rounds();
  EXPECT_GT(test::greatest_odometry_error(two_rounds()), 2.0);
  EXPECT_LT(test::greatest_error(slam, steps, two_rounds()), 0.06);
  EXPECT_EQ(test::false_closures(slam, test::keyframe_truth(steps, two_rounds())), 0U);
  EXPECT_TRUE(slam.anchored());
}

TEST(FeatureSlam, NeedsNoOdometry) {
  test::SlamDrive drive = two_rounds();
  const Pose2 world_T_map = drive.front().world_T_base;
  test::forget_odometry(drive);
  for (test::SlamInput& input : drive) {
    input.world_T_base = world_T_map.inverse() * input.world_T_base;
  }
  const auto [slam, steps] = run_of(drive);
  EXPECT_LT(test::greatest_error(slam, steps, drive), 0.06);
}

TEST(FeatureSlam, ClosesLoopsWithWhatIsNear) {
  std::size_t near = 0;
  for (const SlamClosure& closure : run_of_two_rounds().slam.closures()) {
    EXPECT_EQ(closure.accepted, closure.verdict == "accepted");
    near += closure.accepted && closure.origin == ClosureOrigin::kNearby ? 1U : 0U;
  }
  EXPECT_GT(near, 50U);
}

TEST(FeatureSlam, GivesTheSameForTheSame) {
  const auto& [first, a] = run_of_two_rounds();
  const auto [second, b] = run_of(two_rounds());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].map_T_base.x(), b[i].map_T_base.x()) << i;
    EXPECT_EQ(a[i].map_T_base.theta(), b[i].map_T_base.theta()) << i;
  }
  ASSERT_EQ(first.keyframes(), second.keyframes());
  for (std::size_t i = 0; i < first.keyframes(); ++i) {
    EXPECT_EQ(first.map_T_laser({i}).x(), second.map_T_laser({i}).x()) << i;
    EXPECT_EQ(first.map_T_laser({i}).y(), second.map_T_laser({i}).y()) << i;
    EXPECT_EQ(first.map_T_laser({i}).theta(), second.map_T_laser({i}).theta()) << i;
  }
  ASSERT_EQ(first.closures().size(), second.closures().size());
  for (std::size_t i = 0; i < first.closures().size(); ++i) {
    EXPECT_EQ(first.closures()[i].source, second.closures()[i].source) << i;
    EXPECT_EQ(first.closures()[i].target, second.closures()[i].target) << i;
    EXPECT_EQ(first.closures()[i].verdict, second.closures()[i].verdict) << i;
    EXPECT_EQ(first.closures()[i].score, second.closures()[i].score) << i;
  }
}

TEST(FeatureSlam, TheStepIsThatOfTheKeyframe) {
  FeatureSlam slam;
  const SlamStep first = slam.add(two_rounds().front().scan);
  ASSERT_TRUE(first.is_keyframe && first.keyframe);
  EXPECT_LT(test::distance(first.map_T_base, two_rounds().front().world_T_base), 1e-9);
  EXPECT_LT(test::distance(slam.map_T_laser({0}) * first.keyframe_T_base, first.map_T_base), 1e-9);
  for (std::size_t i = 1; i < 100; ++i) {
    const SlamStep step = slam.add(two_rounds()[i].scan);
    ASSERT_TRUE(step.keyframe) << i;
    EXPECT_EQ(step.keyframe->value, slam.keyframes() - 1) << i;
    EXPECT_LT(
        test::distance(slam.map_T_laser(*step.keyframe) * step.keyframe_T_base, step.map_T_base),
        1e-9);
  }
}

TEST(FeatureSlam, WaitsForAScanThatShowsSomething) {
  FeatureSlam slam;
  SlamScan blind = two_rounds().front().scan;
  blind.scan = test::round_scan(test::kNoRange);
  const SlamStep step = slam.add(blind);
  EXPECT_FALSE(step.keyframe);
  EXPECT_TRUE(step.lost);
  EXPECT_FALSE(slam.anchored());
  EXPECT_EQ(slam.keyframes(), 0U);
  EXPECT_LT(test::distance(step.map_T_base, *blind.odom_T_base), 1e-12);
  slam.finish();
  EXPECT_TRUE(slam.state().keyframes.empty());
  EXPECT_TRUE(slam.add(two_rounds().front().scan).is_keyframe);
}

TEST(FeatureSlam, TellsWhatItIsBusyWith) {
  FeatureSlam slam;
  std::vector<SlamStage> stages;
  slam.on_stage([&](SlamStage stage) { stages.push_back(stage); });
  slam.add(two_rounds().front().scan);
  ASSERT_GE(stages.size(), 4U);
  EXPECT_EQ(stages.front(), SlamStage::kTracking);
  EXPECT_EQ(stages.back(), SlamStage::kIdle);
}

TEST(SlamParams, NamesFieldAndValueOfWhatIsWrong) {
  SlamParams params;
  params.graph.optimize_every = 0;
  try {
    FeatureSlam slam(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("optimize_every = 0"), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
