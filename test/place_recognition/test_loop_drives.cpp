// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The loop detector over drives whose odometries are not connected.
#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/place_recognition/loop_detector.hpp"
#include "support/drives.hpp"

namespace falko_slam {
namespace {

constexpr double kStep = 0.6;

// Twice along the corridor of the office, the second time beside the first.
class LoopDrives : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto random = test::seeded_random();
    const test::Poses lap = office_path(kStep);
    length_ = std::min<std::size_t>(lap.size(), 24);
    test::Poses path(lap.begin(), lap.begin() + static_cast<std::ptrdiff_t>(length_));
    for (std::size_t i = 0; i < length_; ++i) path.push_back(path[i] * Pose2(0.2, 0.1, 0.1));
    scans_ = test::drive(office_scene(), path, random);
  }
  static void TearDownTestSuite() { scans_.clear(); }

  // The second drive with an odometry that starts elsewhere.
  static LoopDetector two_drives(const Pose2& second_T_first) {
    LoopDetector detector;
    for (std::size_t i = 0; i < scans_.size(); ++i) {
      if (i == length_) detector.begin_drive();
      const Pose2& pose = scans_[i].map_T_laser;
      detector.add(scans_[i].scan, i < length_ ? pose : second_T_first * pose);
    }
    return detector;
  }

  static inline std::size_t length_ = 0;
  static inline std::vector<PosedScan> scans_;
};

TEST_F(LoopDrives, AreCountedAndTheirPathsBeginAnew) {
  const LoopDetector detector = two_drives({100.0, 0.0, 0.0});
  for (const Keyframe& keyframe : detector.keyframes()) {
    EXPECT_EQ(keyframe.drive, keyframe.id.value < length_ ? 0U : 1U);
  }
  EXPECT_EQ(detector.keyframes()[length_].path, 0.0);
  EXPECT_NEAR(detector.keyframes()[length_ + 1].path, kStep, 0.1);
}

TEST_F(LoopDrives, CloseWithEachOtherBeforeTheLeastWay) {
  LoopDetector detector = two_drives({100.0, -3.0, 2.0});
  std::size_t closed = 0;
  for (std::size_t source = length_; source < scans_.size(); ++source) {
    if (detector.keyframes()[source].path >= detector.params().min_path) break;
    const LoopDetection detection = detector.detect({source});
    const LoopCandidate* loop = detection.accepted();
    if (loop == nullptr) continue;
    ++closed;
    EXPECT_LT(loop->target.value, length_);
    EXPECT_TRUE(test::is_right(detector.keyframes()[loop->target.value], scans_[source].map_T_laser,
                               loop->target_T_source->pose));
  }
  EXPECT_GE(closed, 6U);
}

TEST_F(LoopDrives, DoNotCloseWhereThatIsNotPossible) {
  LoopDetector detector = two_drives({100.0, -3.0, 2.0});
  std::size_t asked = 0, closed = 0;
  for (std::size_t source = length_; source < scans_.size(); source += 5) {
    const LoopDetection free = detector.detect({source});
    if (free.accepted() == nullptr) continue;
    const Pose2 loop = detector.keyframes()[free.accepted()->target.value].mended_T_laser *
                       free.accepted()->target_T_source->pose;
    const auto distance = [&](const Keyframe& target, const Pose2& target_T_source) {
      ++asked;
      return ((target.mended_T_laser * target_T_source).translation() - loop.translation()).norm();
    };
    const auto far = [&](const Keyframe& target, const Pose2& pose) {
      return target.drive > 0 || distance(target, pose) > 2.0;
    };
    const auto near = [&](const Keyframe& target, const Pose2& pose) {
      return target.drive == 0 && distance(target, pose) < 2.0;
    };
    for (const LoopCandidate& candidate : detector.detect({source}, {}, far).candidates) {
      if (candidate.verdict != LoopVerdict::kAccepted) continue;
      const Keyframe& target = detector.keyframes()[candidate.target.value];
      EXPECT_TRUE(far(target, candidate.target_T_source->pose)) << source;
    }
    closed += detector.detect({source}, {}, near).accepted() != nullptr ? 1U : 0U;
    EXPECT_EQ(detector.detect({source}).accepted()->target, free.accepted()->target);
  }
  EXPECT_GE(closed, 3U);
  EXPECT_GT(asked, 100U);
}

// Whatever looked across the seam, at poses or at the way, would tell where the odometry starts.
TEST_F(LoopDrives, DoNotDependOnWhereTheirOdometriesStart) {
  LoopDetector here = two_drives({0.0, 0.0, 0.0});
  LoopDetector there = two_drives({30.0, -70.0, 2.5});
  for (std::size_t source = 0; source < scans_.size(); ++source) {
    const auto a = here.detect({source}).candidates;
    const auto b = there.detect({source}).candidates;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].target, b[i].target) << source;
      EXPECT_EQ(a[i].verdict, b[i].verdict) << source;
      EXPECT_NEAR(a[i].score, b[i].score, 0.01) << source;
    }
  }
}

TEST_F(LoopDrives, BeginWithAKeyframeHoweverOftenTheyAreAnnounced) {
  LoopDetector detector;
  detector.begin_drive();
  detector.add(scans_[0].scan, {});
  detector.begin_drive();
  detector.begin_drive();
  detector.add(scans_[1].scan, {});
  EXPECT_EQ(detector.keyframes()[0].drive, 0U);
  EXPECT_EQ(detector.keyframes()[1].drive, 1U);
}

}  // namespace
}  // namespace falko_slam
