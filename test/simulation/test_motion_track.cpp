// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/motion_track.hpp"

#include <gtest/gtest.h>

#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using test::kBegin;
constexpr double kRounding = 1e-12;

double off_by(const Pose2& a, const Pose2& b) { return (a.inverse() * b).log().norm(); }

TEST(MotionTrack, IsTheArcAtEveryInstant) {
  const Pose2 start(1.0, 2.0, 3.0);
  const Eigen::Vector3d tangent(0.8, 0.0, 0.5);
  const MotionTrack track = test::track_of(start, tangent);

  for (const double seconds : {0.0, 0.0003, 0.001, 0.4567, 0.9999, 1.0}) {
    const Pose2 expected = start * Pose2::exp(seconds * tangent);
    EXPECT_LT(off_by(track.at(kBegin + from_seconds(seconds)), expected), 1e-9) << seconds;
  }
}

TEST(MotionTrack, StaysAtItsEnds) {
  const MotionTrack track = test::track_of({1.0, 2.0, 3.0}, {1.0, 0.0, 0.2});

  EXPECT_LT(off_by(track.at(kBegin - from_seconds(5.0)), {1.0, 2.0, 3.0}), kRounding);
  EXPECT_LT(off_by(track.at(kBegin + from_seconds(5.0)), track.last()), kRounding);
}

TEST(MotionTrack, IsOnePoseBeforeItMoves) {
  const MotionTrack track(kBegin, {1.0, 2.0, 3.0});

  EXPECT_EQ(track.begin(), kBegin);
  EXPECT_EQ(track.end(), kBegin);
  EXPECT_LT(off_by(track.at(kBegin), {1.0, 2.0, 3.0}), kRounding);
}

TEST(MotionTrack, ForgetsOnlyWhatIsBefore) {
  MotionTrack track = test::track_of({}, {1.0, 0.0, 0.2});
  const Time kept = kBegin + from_seconds(0.5004);
  const Pose2 expected = track.at(kept);

  track.forget_before(kept);

  EXPECT_LE(track.begin(), kept);
  EXPECT_GT(track.begin(), kBegin);
  EXPECT_LT(off_by(track.at(kept), expected), kRounding);
}

}  // namespace
}  // namespace falko_slam
