// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_agreement.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/hand_made_scans.hpp"
#include "support/scan_views.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

TEST(ScanAgreement, AScanAgreesWithItself) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::room_with_pillar(), {}, random);
  const Agreement self = agreement(view, view, {});
  EXPECT_EQ(self.points, view.points().size());
  EXPECT_EQ(self.agreeing, self.points);
  EXPECT_EQ(self.agreeing_length, self.length);
  EXPECT_EQ(self.ratio(), 1.0);
}

TEST(ScanAgreement, TakesEveryStridethPoint) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::room_with_pillar(), {}, random);
  for (const std::size_t stride : {1U, 2U, 5U}) {
    EXPECT_EQ(agreement(view, view, {}, {}, stride).points,
              (view.points().size() + stride - 1) / stride);
  }
}

TEST(ScanAgreement, EveryPointCountsAtMostOnce) {
  auto random = test::seeded_random();
  const ScanView target = test::view_of(test::room_with_pillar(), {}, random);
  for (int run = 0; run < 50; ++run) {
    const Pose2 pose(test::uniform(random, -3.0, 3.0), test::uniform(random, -3.0, 3.0),
                     test::uniform(random, -kPi, kPi));
    const Agreement found = agreement(target, target, pose);
    EXPECT_LE(found.seen(), found.points);
    EXPECT_LE(found.agreeing_length + found.missed_length + found.seen_through_length,
              found.length + 1e-9);
    EXPECT_GE(found.ratio(), 0.0);
    EXPECT_LE(found.ratio(), 1.0);
  }
}

// A wall before the laser, `distance` away; the other scan saw one at 4 m.
Agreement wall_at(double distance) {
  const auto wall = [](double x) {
    Scene scene;
    scene.walls = {{{x, -0.2 * x}, {x, 0.2 * x}}};
    auto random = test::seeded_random();
    return test::view_of(scene, {}, random, 0.0);
  };
  return agreement(wall(4.0), wall(distance), {});
}

TEST(ScanAgreement, AWallInFrontOfWhatWasSeenIsSeenThrough) {
  const Agreement found = wall_at(2.0);
  EXPECT_GT(found.points, 0U);
  EXPECT_EQ(found.seen_through, found.points);
  EXPECT_EQ(found.ratio(), 0.0);
}

TEST(ScanAgreement, AWallBehindWhatWasSeenSaysNothing) {
  const Agreement found = wall_at(6.0);
  EXPECT_GT(found.points, 0U);
  EXPECT_EQ(found.seen(), 0U);
}

TEST(ScanAgreement, AWallBesideWhatWasSeenIsMissed) {
  for (const double distance : {3.8, 4.2}) {
    const Agreement found = wall_at(distance);
    EXPECT_GT(found.missed, 0U);
    EXPECT_EQ(found.missed, found.points) << distance;
  }
}

TEST(ScanAgreement, InvalidBeamsSayNothing) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::square_room(), {}, random);
  const ScanView blind(test::round_scan(test::kNoRange));
  EXPECT_EQ(agreement(blind, view, {}).seen(), 0U);
  EXPECT_EQ(agreement(blind, view, {}).points, view.points().size());
}

TEST(ScanAgreement, EmptyViewsAgreeInNothing) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::square_room(), {}, random);
  EXPECT_EQ(agreement(ScanView(), view, {}).seen(), 0U);
  EXPECT_EQ(agreement(view, ScanView(), {}).points, 0U);
  EXPECT_EQ(agreement(view, ScanView(), {}).ratio(), 0.0);
}

TEST(AgreementParams, NamesFieldAndValueOfWhatIsWrong) {
  AgreementParams params;
  params.tolerance = 0.0;
  try {
    validate(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("tolerance = 0: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
