// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Closures from elsewhere, true ones and false ones.
#include <gtest/gtest.h>

#include <stdexcept>

#include "support/slam_drives.hpp"

namespace falko_slam {
namespace {

PoseEstimate sure(const Pose2& pose) {
  return {pose, Eigen::Vector3d(4e-4, 4e-4, 2.5e-5).asDiagonal()};
}

class ProposedClosures : public ::testing::Test {
 protected:
  void SetUp() override {
    auto random = test::seeded_random();
    drive_ = test::slam_drive(office_scene(), office_path(0.1), random);
    test::let_drift(drive_, random);
    steps_ = test::run(slam_, drive_);
    truth_ = test::keyframe_truth(steps_, drive_);
    ASSERT_EQ(truth_.size(), slam_.keyframes());
  }
  double error() {
    slam_.finish();
    return test::greatest_error(slam_, steps_, drive_);
  }
  Pose2 true_way(std::size_t target, std::size_t source) const {
    return truth_[target].inverse() * truth_[source];
  }

  FeatureSlam slam_;
  test::SlamDrive drive_;
  std::vector<SlamStep> steps_;
  test::Poses truth_;
};

TEST_F(ProposedClosures, AreAcceptedIfTrue) {
  const std::size_t last = slam_.keyframes() - 1;
  std::size_t accepted = 0;
  for (std::size_t back = 0; back < 5; ++back) {
    const SlamClosure closure =
        slam_.propose({back}, {last - back}, sure(true_way(back, last - back)));
    EXPECT_EQ(closure.origin, ClosureOrigin::kProposed);
    accepted += closure.accepted ? 1U : 0U;
  }
  EXPECT_GE(accepted, 4U);
  EXPECT_LT(error(), 0.06);
}

TEST_F(ProposedClosures, AreRefusedIfFalse) {
  const double before = error();
  auto random = test::seeded_random();
  for (int i = 0; i < 40; ++i) {
    const auto source = static_cast<std::size_t>(
        test::uniform(random, 20.0, static_cast<double>(slam_.keyframes()) - 1e-9));
    const auto target =
        static_cast<std::size_t>(test::uniform(random, 0.0, static_cast<double>(source) - 1e-9));
    const Pose2 wrong(test::uniform(random, -3.0, 3.0), test::uniform(random, -3.0, 3.0),
                      test::uniform(random, -kPi, kPi));
    slam_.propose({target}, {source}, sure(wrong));
  }
  EXPECT_EQ(test::false_closures(slam_, truth_), 0U);
  EXPECT_LT(error(), before + 0.02);
}

TEST_F(ProposedClosures, SayWhichKeyframeIsNotThere) {
  try {
    slam_.propose({0}, {slam_.keyframes()}, sure({}));
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(slam_.keyframes())), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
