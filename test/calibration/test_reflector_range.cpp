// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_range.hpp"

#include <gtest/gtest.h>

#include "falko_slam/geometry/angles.hpp"
#include "reflector_halls.hpp"

namespace falko_slam {
namespace {

std::vector<ReflectorMotion> motions_with_offset(double offset, double noise, int count) {
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(9, random);
  std::vector<ReflectorMotion> motions;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d arc(6.0 + 0.3 * i, 0.0, i % 2 == 0 ? 3.0 : -3.0);
    motions.push_back(test::driven(hall, arc, noise, random, 0.03, offset).result().value());
  }
  return motions;
}

TEST(RangeOffset, IsFoundFromBothEndsOfArcs) {
  for (const double offset : {0.0, 0.004, -0.012}) {
    const RangeOffset found = estimate_range_offset(motions_with_offset(offset, 0.003, 16));
    EXPECT_NEAR(found.offset, offset, 4.0 * found.deviation);
    EXPECT_LT(found.deviation, 0.002);
  }
}

TEST(RangeOffset, MendsTheMotion) {
  const auto motions = motions_with_offset(0.01, 0.0, 8);
  const RangeOffset found = estimate_range_offset(motions);
  for (int i = 0; i < 8; ++i) {
    const Pose2 truth = Pose2::exp(Eigen::Vector3d(6.0 + 0.3 * i, 0.0, i % 2 == 0 ? 3.0 : -3.0));
    const auto& before = motions[static_cast<std::size_t>(i)];
    const ReflectorMotion mended = with_range_offset(before, found.offset);
    EXPECT_LT((truth.inverse() * mended.start_T_end.pose).log().norm(), 5e-4) << i;
    EXPECT_EQ(mended.scans, before.scans);
    EXPECT_NEAR(mended.turn, before.turn, 0.01);
  }
}

TEST(RangeOffset, OfNoMotionIsThePrior) {
  const RangeOffset found = estimate_range_offset({}, 0.03);
  EXPECT_EQ(found.offset, 0.0);
  EXPECT_EQ(found.deviation, 0.03);
}

}  // namespace
}  // namespace falko_slam
