// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// SLAM where it is hardest: four corridors of 60 m around a block, driven twice with a laser that
// sees little of them and an odometry that ends 40 m off.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/corridor_ring.hpp"

namespace falko_slam {
namespace {

constexpr double kStep = 0.2;  // of the way between two scans [m]

struct Result {
  double odometry_error, final_error;  // greatest [m]
  std::size_t false_places, closures, lost;
};

// Recognised places that are accepted and wrong as the thesis counts it, by 0.5 m or 10 degrees.
std::size_t false_places(const FeatureSlam& slam, const test::Poses& truth) {
  std::size_t count = 0;
  for (const SlamClosure& closure : slam.closures()) {
    if (!closure.accepted || closure.origin != ClosureOrigin::kPlace) continue;
    const Pose2 expected = truth[closure.target.value].inverse() * truth[closure.source.value];
    const Pose2 error = expected.inverse() * closure.target_T_source;
    const bool wrong =
        error.translation().norm() > 0.5 || std::abs(error.theta()) > degrees_to_radians(10.0);
    count += wrong ? 1U : 0U;
  }
  return count;
}

Result drive_twice(const test::CorridorRing& ring) {
  auto random = test::seeded_random();
  const Scene scene = test::scene_of(ring, random);
  auto drive = test::drive_around(scene, test::path_of(ring, 2.0, kStep), random);
  test::mistake_steps(drive, [&](const Pose2& step) {
    const double way = step.translation().norm();
    return Pose2((1.02 + test::normal(random, 0.02)) * step.translation(),
                 step.theta() + 0.002 * way + test::normal(random, 0.0087) * std::sqrt(way));
  });
  FeatureSlam slam;
  const auto steps = test::run(slam, drive);
  slam.finish();
  const test::Poses truth = test::keyframe_truth(steps, drive);
  Result result{test::greatest_odometry_error(drive), test::greatest_error(slam, steps, drive),
                false_places(slam, truth), 0, 0};
  for (const SlamClosure& closure : slam.closures()) result.closures += closure.accepted ? 1U : 0U;
  for (const SlamStep& step : steps) result.lost += step.lost ? 1U : 0U;
  return result;
}

void record(const Result& result) {
  ::testing::Test::RecordProperty("odometry_error_m", std::to_string(result.odometry_error));
  ::testing::Test::RecordProperty("final_error_m", std::to_string(result.final_error));
  ::testing::Test::RecordProperty("closures", std::to_string(result.closures));
}

TEST(LongCorridors, AreClosed) {
  const Result result = drive_twice({});
  record(result);
  EXPECT_GT(result.odometry_error, 20.0);
  EXPECT_LT(result.final_error, 0.6);
  EXPECT_EQ(result.false_places, 0U);
  EXPECT_EQ(result.lost, 0U);
}

// All doors and all corners are alike: what was taken for something else must not be in the map in
// the end.
TEST(LongCorridors, NoFalsePlaceIsLeftWhereAllIsAlike) {
  test::CorridorRing ring;
  ring.irregularity = 0.0;
  ring.side_rooms = 0;
  const Result result = drive_twice(ring);
  record(result);
  EXPECT_GT(result.odometry_error, 20.0);
  EXPECT_LT(result.final_error, 1.5);
  EXPECT_EQ(result.false_places, 0U);
  EXPECT_EQ(result.lost, 0U);
}

}  // namespace
}  // namespace falko_slam
