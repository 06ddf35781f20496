// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "shared_halt.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "calibration/reflector_halls.hpp"

namespace falko_slam {
namespace {

const Pose2 kFirst(4.0, 7.0, 3.0);   // of the halt, seen from where the first arc began
const Pose2 kSecond(2.0, 5.0, 2.6);  // of the next one, seen from the halt

ReflectorMotion motion_between(const Pose2& start, const Pose2& end, const ReflectorPoints& hall) {
  std::vector<PointPair> pairs;
  double weight = 2e4;
  for (const Eigen::Vector2d& reflector : hall) {
    pairs.push_back({start.inverse() * reflector, end.inverse() * reflector, weight});
    weight *= 1.2;
  }
  return motion_of(pairs).value();
}

Eigen::Vector3d vector_of(const Pose2& pose) { return {pose.x(), pose.y(), pose.theta()}; }

TEST(SharedHalt, IsWhatDisplacedReflectorsDoToBothMotions) {
  constexpr double kStep = 1e-5, kNoise = 0.002;
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(7, random);
  ReflectorPoints partly(hall.begin() + 1, hall.end());  // one was not seen at the second end
  const ReflectorMotion before = motion_between({}, kFirst, hall);
  const ReflectorMotion after = motion_between(kFirst, kFirst * kSecond, partly);
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < partly.size(); ++i) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      std::vector<PointPair> first = before.pairs, second = after.pairs;
      first[i + 1].point_in_source[axis] += kStep;
      second[i].point_in_target[axis] += kStep;
      const Eigen::Vector3d by_first =
          vector_of(motion_of(first)->start_T_end.pose) - vector_of(before.start_T_end.pose);
      const Eigen::Vector3d by_second =
          vector_of(motion_of(second)->start_T_end.pose) - vector_of(after.start_T_end.pose);
      expected += kNoise * kNoise / (kStep * kStep) * by_first * by_second.transpose();
    }
  }

  const Eigen::Matrix3d found = covariance_at_halt(before, after, kNoise);

  EXPECT_LT((found - expected).norm(), 1e-3 * expected.norm()) << found << "\n\n" << expected;
}

TEST(SharedHalt, HasNothingInCommonElsewhere) {
  auto random = test::seeded_random();
  const ReflectorMotion one = motion_between({}, kFirst, test::reflector_hall(7, random));
  const ReflectorMotion other = motion_between({}, kSecond, test::reflector_hall(5, random));
  EXPECT_EQ(covariance_at_halt(one, other, 0.002).norm(), 0.0);
}

TEST(SharedHalt, SharesNoMoreThanTheMotionsErr) {
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(7, random);
  const ReflectorMotion before = motion_between({}, kFirst, hall);
  const ReflectorMotion after = motion_between(kFirst, kFirst * kSecond, hall);
  Eigen::Matrix<double, 6, 6> both;
  both.topLeftCorner<3, 3>() = before.start_T_end.covariance;
  both.bottomRightCorner<3, 3>() = after.start_T_end.covariance;
  both.topRightCorner<3, 3>() = covariance_at_halt(before, after, 10.0);
  both.bottomLeftCorner<3, 3>() = both.topRightCorner<3, 3>().transpose();
  EXPECT_EQ(both.llt().info(), Eigen::Success);
}

}  // namespace
}  // namespace falko_slam
