// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_evidence.hpp"

#include <gtest/gtest.h>

#include "falko_slam/localization/localizer_params.hpp"
#include "falko_slam/localization/pose_hypotheses.hpp"
#include "localization/scan_of_room.hpp"

namespace falko_slam {
namespace {

constexpr double kSeenDeviation = 0.01;

// Five reflectors that no turn and no shift lays over each other.
class PoseEvidenceTest : public ::testing::Test {
 protected:
  PoseEvidenceTest() {
    int id = 0;
    for (const Eigen::Vector2d& place :
         {Eigen::Vector2d(4.9, 2.0), Eigen::Vector2d(-4.9, 1.0), Eigen::Vector2d(1.0, -2.9),
          Eigen::Vector2d(-3.0, 2.9), Eigen::Vector2d(4.0, -2.9)}) {
      MapLandmark landmark;
      landmark.id = id++;
      landmark.position = place;
      map_.landmarks.push_back(landmark);
      landmarks_.push_back({static_cast<std::uint32_t>(landmark.id), place});
    }
    index_ = std::make_shared<LandmarkIndex>(landmarks_);
  }
  PoseEvidence evidence() const {
    return {{}, {mount_, {}}, map_, index_, AssociationParams{}.gate_probability};
  }
  std::vector<LandmarkObservation> seen_from(const Pose2& map_T_base) const {
    std::vector<LandmarkObservation> observations;
    for (const Landmark& landmark : landmarks_) {
      observations.push_back({ObservationModel::kCartesian,
                              (map_T_base * mount_).inverse() * landmark.position,
                              kSeenDeviation * kSeenDeviation * Eigen::Matrix2d::Identity(),
                              {}});
    }
    return observations;
  }
  ScanEvidence judge(const Pose2& believed, const std::vector<LandmarkObservation>& seen,
                     const ScanSight* sight = nullptr) const {
    const PoseEstimate prior{believed, pose_covariance(0.05, 0.01)};
    PoseUpdate update;
    update.association = associate(prior, mount_, *index_, seen, {});
    return evidence().judge(prior, seen, update, sight);
  }

  const Pose2 mount_{0.2, 0.0, 0.1};
  const Pose2 truth_{0.3, -0.4, 0.5};
  LandmarkMap map_;
  std::vector<Landmark> landmarks_;
  std::shared_ptr<const LandmarkIndex> index_;
};

TEST_F(PoseEvidenceTest, SpeaksForTheRightPlaceAndAgainstAWrongOne) {
  const ScanEvidence right = judge(truth_, seen_from(truth_));
  EXPECT_EQ(right.agreement.used, 5U);
  EXPECT_GT(right.log_odds, 5.0);
  EXPECT_EQ(right.log_odds, right.reflector_log_odds);
  const ScanEvidence wrong = judge(Pose2(-1.0, 1.0, 2.0), seen_from(truth_));
  EXPECT_LT(wrong.agreement.used, 2U);
  EXPECT_GT(wrong.agreement.strangers, 2U);
  EXPECT_LT(wrong.log_odds, 0.0);
}

TEST_F(PoseEvidenceTest, CountsWhatShouldHaveBeenSeen) {
  Scene room;
  room.add_box({}, {10.0, 6.0});
  const LaserScan scan = test::scan_of(room, truth_ * mount_);
  const ScanSight sight(scan);
  std::vector<LandmarkObservation> seen = seen_from(truth_);
  seen.resize(3);

  const ScanEvidence all = judge(truth_, seen_from(truth_), &sight);
  const ScanEvidence some = judge(truth_, seen, &sight);

  EXPECT_EQ(all.agreement.expected, 5U);
  EXPECT_EQ(all.agreement.missed, 0U);
  EXPECT_GT(some.agreement.missed, 0U);
  EXPECT_LT(some.log_odds, all.log_odds);
}

TEST_F(PoseEvidenceTest, HypothesesDecideForThePlaceThatIsRight) {
  LocalizerParams params;
  params.base_T_laser = mount_;
  const PoseEvidence evidence = this->evidence();
  PoseHypotheses hypotheses(params, index_, evidence);
  EXPECT_FALSE(hypotheses.decided());
  Pose2 pose = truth_;
  const Pose2 step(0.1, 0.0, 0.05);
  for (int scan = 0; scan < 8; ++scan) {
    if (scan > 0) {
      hypotheses.move({step, pose_covariance(0.002, 0.001)});
      pose = pose * step;
    }
    hypotheses.add_scan(seen_from(pose), nullptr);
  }
  const auto found = hypotheses.decided();
  ASSERT_TRUE(found);
  EXPECT_LT((found->map_T_base.pose.inverse() * pose).log().norm(), 0.02);
  EXPECT_TRUE(hypotheses.decided_with_corners());
  EXPECT_GE(found->scans, params.recovery.scans);
  hypotheses.clear();
  EXPECT_TRUE(hypotheses.places().empty());
}

}  // namespace
}  // namespace falko_slam
