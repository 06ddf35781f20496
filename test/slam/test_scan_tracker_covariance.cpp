// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the tracker is as sure of its poses as it may be: the mean square of the error in
// standard deviations (NEES) of 3 degrees of freedom is 3.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <optional>

#include "support/tracked_drives.hpp"

namespace falko_slam {
namespace {

// What the tracker adds for walls that are not straight and lasers that are not calibrated, which
// there are not in a simulation: 5 mm and 1 mrad.
const Eigen::Matrix3d kReserve = Eigen::Vector3d(25e-6, 25e-6, 1e-6).asDiagonal();

// Of each keyframe, seen from the one before it.
std::vector<double> nees_of(const test::SlamDrive& drive, const Eigen::Matrix3d& reserve) {
  const auto tracked = test::follow(drive);
  std::vector<double> result;
  std::optional<Pose2> keyframe;
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    if (!tracked[i].keyframe) continue;
    const Pose2 here = test::true_laser(drive, i);
    if (keyframe) {
      const PoseEstimate& found = tracked[i].keyframe_T_laser;
      const Pose2 truth = keyframe->inverse() * here;
      const Eigen::Vector3d error(found.pose.x() - truth.x(), found.pose.y() - truth.y(),
                                  angle_between(truth.theta(), found.pose.theta()));
      const Eigen::Matrix3d covariance = found.covariance - reserve;
      result.push_back(error.dot(covariance.inverse() * error));
    }
    keyframe = here;
  }
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

class ScanTrackerCovariance : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ScanTrackerCovariance, IsThatOfItsErrors) {
  auto random = test::seeded_random();
  auto drive = test::slam_drive(office_scene(), office_path(0.1), random, GetParam());
  test::mistake_steps(drive, [&](const Pose2& step) {
    return step * Pose2(test::normal(random, 0.02), test::normal(random, 0.02),
                        test::normal(random, 0.02));
  });
  const auto nees = nees_of(drive, kReserve);
  ASSERT_GT(nees.size(), 60U);
  EXPECT_GT(mean(nees), 1.5);
  EXPECT_LT(mean(nees), 6.0);
  EXPECT_LT(mean(nees_of(drive, Eigen::Matrix3d::Zero())), 3.0);
}
INSTANTIATE_TEST_SUITE_P(Beams, ScanTrackerCovariance, ::testing::Values(180U, 360U, 720U));

}  // namespace
}  // namespace falko_slam
