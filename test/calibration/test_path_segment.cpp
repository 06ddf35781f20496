// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/path_segment.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "calibration/arc_drives.hpp"

namespace falko_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const std::vector<PathSegment>& segments) {
  try {
    validate(segments);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::vector<PathSegment> sound() { return test::exact_segments(test::cb16()); }

TEST(PathSegment, IsSoundAfterExactDrives) { EXPECT_EQ(refusal(sound()), ""); }

TEST(PathSegment, IsRefusedByNumberAndFieldWhereItIsNotFinite) {
  auto segments = sound();
  segments[2].ticks = kNan;
  EXPECT_EQ(refusal(segments), "segments[3].ticks = nan: must be finite");
  segments = sound();
  segments[0].steering = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(segments), "segments[1].steering = inf: must be finite");
  segments = sound();
  segments[1].turn = kNan;
  EXPECT_EQ(refusal(segments), "segments[2].turn = nan: must be finite");
  segments = sound();
  segments[1].start_T_end.pose = Pose2(0.0, kNan, 0.0);
  EXPECT_NE(refusal(segments).find("segments[2].start_T_end.y"), std::string::npos);
}

TEST(PathSegment, IsRefusedWithoutTicks) {
  auto segments = sound();
  segments[4].ticks = 0.0;
  EXPECT_EQ(refusal(segments), "segments[5].ticks = 0: the driven wheel did not turn");
}

TEST(PathSegment, IsRefusedIfTheWheelIsTurnedAllTheWay) {
  auto segments = sound();
  segments[1].steering = -3.2;
  EXPECT_EQ(refusal(segments), "segments[2].steering = -3.2: must be in (-pi, pi)");
}

TEST(PathSegment, IsRefusedIfTheCovarianceIsNone) {
  auto segments = sound();
  segments[0].start_T_end.covariance.setZero();
  EXPECT_NE(refusal(segments).find("positive definite"), std::string::npos);
  segments = sound();
  segments[0].start_T_end.covariance(0, 1) = 1.0;
  EXPECT_NE(refusal(segments).find("symmetric"), std::string::npos);
  segments = sound();
  segments[0].start_T_end.covariance(2, 2) = kNan;
  EXPECT_NE(refusal(segments).find("covariance"), std::string::npos);
}

TEST(PathSegment, IsRefusedIfItSharesMoreWithTheNextThanBothErr) {
  auto segments = sound();
  segments[3].covariance_with_next = -0.5 * segments[3].start_T_end.covariance;
  EXPECT_EQ(refusal(segments), "");
  segments[3].covariance_with_next *= 2.1;
  EXPECT_NE(refusal(segments).find("segments[4].covariance_with_next"), std::string::npos)
      << refusal(segments);
  segments[3].covariance_with_next.setConstant(kNan);
  EXPECT_NE(refusal(segments).find("segments[4].covariance_with_next"), std::string::npos);
}

TEST(PathSegment, IsRefusedIfTheTurnIsNotItsHeading) {
  auto segments = sound();
  segments[0].turn += 0.1;
  EXPECT_NE(refusal(segments).find("segments[1].turn"), std::string::npos);
  segments[0].turn += kTwoPi - 0.1;
  EXPECT_EQ(refusal(segments), "");
}

TEST(PathSegment, HasThePhaseOfItsDirectionAndSide) {
  PathSegment segment;
  segment.ticks = 1.0;
  segment.steering = 0.3;
  EXPECT_EQ(phase_of(segment), DrivePhase::kForwardLeft);
  segment.steering = -0.3;
  EXPECT_EQ(phase_of(segment), DrivePhase::kForwardRight);
  segment.ticks = -1.0;
  EXPECT_EQ(phase_of(segment), DrivePhase::kBackwardRight);
  segment.steering = 0.3;
  EXPECT_EQ(phase_of(segment), DrivePhase::kBackwardLeft);
}

TEST(UnwrappedTurn, IsTheSameDirectionNearest) {
  for (const double about : {0.0, 1e-9, kPi, -kPi, 3.0, 3.0 * kPi, -7.0}) {
    for (const double off : {-3.1, -1e-9, 0.0, 0.4, 3.1}) {
      EXPECT_NEAR(unwrapped_turn(wrap_angle(about + off), about), about + off, 1e-14);
    }
  }
}

}  // namespace
}  // namespace falko_slam
