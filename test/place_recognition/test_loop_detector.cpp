// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/loop_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "support/drives.hpp"
#include "support/hand_made_scans.hpp"

namespace falko_slam {
namespace {

// Two laps through the office, the keyframes of the second one between those of the first.
class LoopDetectorTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto random = test::seeded_random();
    test::Poses path = office_path(kStep);
    lap_ = path.size();
    const Pose2 aside(0.2, 0.1, 0.1);
    for (std::size_t i = 0; i < lap_; ++i) path.push_back(path[i] * aside);
    scans_ = test::drive(office_scene(), path, random);
    detector_ = std::make_unique<LoopDetector>(test::detector_of(scans_));
    detections_ = test::detect_all(*detector_);
  }
  static void TearDownTestSuite() {
    scans_.clear();
    detections_.clear();
    detector_.reset();
  }

  static const Keyframe& keyframe(KeyframeId id) { return detector_->keyframes().at(id.value); }

  static constexpr double kStep = 0.6;
  static inline std::size_t lap_ = 0;
  static inline std::vector<PosedScan> scans_;
  static inline std::unique_ptr<LoopDetector> detector_;
  static inline std::vector<LoopDetection> detections_;
};

// The first lap, on its way back, has not been there yet: the other half of the office looks alike.
TEST_F(LoopDetectorTest, AcceptsOnlyRightLoopsWhereItHasBeen) {
  for (std::size_t source = lap_; source < detections_.size(); ++source) {
    const LoopCandidate* loop = detections_[source].accepted();
    if (loop == nullptr) continue;
    const Keyframe& target = keyframe(loop->target);
    const Pose2& truth = scans_[source].map_T_laser;
    EXPECT_TRUE(test::is_right(target, truth, loop->target_T_source->pose))
        << source << " at " << truth << " with " << loop->target.value << " at "
        << target.odom_T_laser << ": off by "
        << test::error_of(target, truth, loop->target_T_source->pose) << ", score " << loop->score;
  }
}

TEST_F(LoopDetectorTest, ClosesMostOfTheSecondLap) {
  std::size_t closed = 0;
  for (std::size_t source = lap_; source < detections_.size(); ++source) {
    closed += detections_[source].accepted() != nullptr ? 1U : 0U;
  }
  EXPECT_GT(closed, (detections_.size() - lap_) / 2);
}

TEST_F(LoopDetectorTest, AcceptsAtMostTheBestCandidateAndSaysWhatBecameOfTheOthers) {
  for (const LoopDetection& detection : detections_) {
    for (std::size_t i = 0; i < detection.candidates.size(); ++i) {
      const LoopCandidate& candidate = detection.candidates[i];
      EXPECT_STRNE(name_of(candidate.verdict), "unknown");
      EXPECT_EQ(candidate.verdict == LoopVerdict::kNotMatched, !candidate.target_T_source);
      const bool good = candidate.score >= detector_->params().min_score;
      EXPECT_EQ(candidate.verdict == LoopVerdict::kAccepted ||
                    candidate.verdict == LoopVerdict::kAmbiguous,
                good && i == 0);
      EXPECT_EQ(candidate.verdict == LoopVerdict::kNotBest, good && i > 0);
    }
  }
}

TEST_F(LoopDetectorTest, PutsTheBestCandidateFirst) {
  for (const LoopDetection& detection : detections_) {
    for (std::size_t i = 1; i < detection.candidates.size(); ++i) {
      EXPECT_GE(detection.candidates[i - 1].score, detection.candidates[i].score);
    }
  }
}

TEST_F(LoopDetectorTest, LooksAtNothingNearerThanTheLeastWay) {
  std::size_t candidates = 0;
  for (std::size_t source = 0; source < detections_.size(); ++source) {
    for (const LoopCandidate& candidate : detections_[source].candidates) {
      EXPECT_GE(keyframe({source}).path - keyframe(candidate.target).path,
                detector_->params().min_path);
      ++candidates;
    }
  }
  EXPECT_GT(candidates, 0U);
}

TEST_F(LoopDetectorTest, LooksOnlyAtWhatIsAdmitted) {
  const auto even = [](const Keyframe& target) { return target.id.value % 2 == 0; };
  const LoopDetection detection = detector_->detect({lap_}, even);
  EXPECT_FALSE(detection.candidates.empty());
  for (const LoopCandidate& candidate : detection.candidates)
    EXPECT_TRUE(even(keyframe(candidate.target)));
  EXPECT_TRUE(detector_->detect({lap_}, [](const Keyframe&) { return false; }).candidates.empty());
}

TEST_F(LoopDetectorTest, FindsLaterPlacesWhereTheyAreAdmitted) {
  const auto second_lap = [](const Keyframe& target) { return target.id.value >= lap_; };
  std::size_t closed = 0;
  for (std::size_t source = 0; source < lap_; source += 4) {
    const LoopDetection detection = detector_->detect({source}, second_lap);
    const LoopCandidate* loop = detection.accepted();
    if (loop == nullptr) continue;
    ++closed;
    EXPECT_TRUE(test::is_right(keyframe(loop->target), scans_[source].map_T_laser,
                               loop->target_T_source->pose));
  }
  EXPECT_GT(closed, 0U);
}

TEST_F(LoopDetectorTest, GivesTheSameForTheSameDrive) {
  LoopDetector twin = test::detector_of(scans_);
  for (std::size_t source = lap_; source < scans_.size(); ++source) {
    const auto again = twin.detect({source}).candidates;
    const auto& first = detections_[source].candidates;
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      EXPECT_EQ(again[i].target, first[i].target);
      EXPECT_EQ(again[i].verdict, first[i].verdict);
      EXPECT_EQ(again[i].score, first[i].score);
      EXPECT_EQ(again[i].pairs, first[i].pairs);
      ASSERT_EQ(again[i].target_T_source.has_value(), first[i].target_T_source.has_value());
      if (!again[i].target_T_source) continue;
      EXPECT_EQ(again[i].target_T_source->pose.log(), first[i].target_T_source->pose.log());
    }
  }
}

TEST_F(LoopDetectorTest, LocatesAScanTakenBesideAKeyframe) {
  auto random = test::seeded_random();
  for (std::size_t id = 0; id < lap_; id += 6) {
    const Pose2 beside = scans_[id].map_T_laser * Pose2(0.1, -0.1, -0.4);
    const LaserScan scan = test::closed_scan(office_scene(), beside, 360, 0.01, random);
    const auto places = detector_->locate(scan, 3);
    ASSERT_FALSE(places.empty()) << beside;
    EXPECT_LE(places.size(), 3U);
    EXPECT_EQ(places[0].score, places[0].scan_score);
    EXPECT_TRUE(test::is_right(keyframe(places[0].target), beside, places[0].target_T_source->pose))
        << beside << ": off by "
        << test::error_of(keyframe(places[0].target), beside, places[0].target_T_source->pose);
  }
}

TEST_F(LoopDetectorTest, LocatesNothingFromAScanWithoutAValidBeam) {
  EXPECT_TRUE(detector_->locate(test::round_scan(test::kNoRange), 3).empty());
}

TEST_F(LoopDetectorTest, LocatesOnlyWhereItIsAdmitted) {
  const auto places = detector_->locate(
      scans_[0].scan, 5, [](const Keyframe& target) { return target.id.value != 0; });
  EXPECT_FALSE(places.empty());
  for (const LoopCandidate& place : places) EXPECT_NE(place.target.value, 0U);
}

TEST_F(LoopDetectorTest, KnowsNoKeyframeThatWasNotAdded) {
  EXPECT_THROW(detector_->detect({scans_.size()}), std::out_of_range);
  EXPECT_THROW(LoopDetector().detect({0}), std::out_of_range);
}

TEST(LoopDetectorParams, NamesFieldAndValueOfWhatIsWrong) {
  const auto error_of = [](auto&& change) {
    LoopDetectorParams params;
    change(params);
    try {
      LoopDetector detector(params);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto expect_named = [&](const std::string& text, auto&& change) {
    EXPECT_EQ(error_of(change).find(text + ": must be in"), 0U) << text << ": " << error_of(change);
  };
  const double nan = std::nan("");
  expect_named("candidates = 0", [](auto& p) { p.candidates = 0; });
  expect_named("verified = 1001", [](auto& p) { p.verified = 1001; });
  expect_named("compared = 0", [](auto& p) { p.compared = 0; });
  expect_named("neighborhood = -1", [](auto& p) { p.neighborhood = -1.0; });
  expect_named("neighbor_spacing = nan", [&](auto& p) { p.neighbor_spacing = nan; });
  expect_named("max_neighbors = -1", [](auto& p) { p.max_neighbors = -1; });
  expect_named("min_path = nan", [&](auto& p) { p.min_path = nan; });
  expect_named("min_score = 1.5", [](auto& p) { p.min_score = 1.5; });
  expect_named("wall_spacing = 0", [](auto& p) { p.keyframe.wall_spacing = 0.0; });
  expect_named("wall_range = nan", [&](auto& p) { p.keyframe.wall_range = nan; });
  expect_named("max_range = 0", [](auto& p) { p.keyframe.view.max_range = 0.0; });
  expect_named("min_jump = 0", [](auto& p) { p.keyframe.wall_end.min_jump = 0.0; });
  expect_named("inlier_distance = 0", [](auto& p) { p.matcher.inlier_distance = 0.0; });
  expect_named("tolerance = 0", [](auto& p) { p.agreement.tolerance = 0.0; });
  expect_named("see_through = nan", [&](auto& p) { p.agreement.see_through = nan; });
  expect_named("iterations = 0", [](auto& p) { p.registration.iterations = 0; });
  expect_named("first_gate = -1", [](auto& p) { p.registration.first_gate = -1.0; });
  expect_named("last_gate = nan", [&](auto& p) { p.registration.last_gate = nan; });
}

}  // namespace
}  // namespace falko_slam
