// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/pose_bytes.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/numbers.hpp"
#include "support/poses.hpp"

namespace falko_slam {
namespace {

TEST(PoseBytes, GiveThePoseBack) {
  const Pose2 pose(1.5, -2e5, -3.0);
  ByteWriter out;
  put(out, pose);
  ASSERT_EQ(out.bytes().size(), kPoseBytes);
  ByteReader in(out.bytes(), 0, out.bytes().size());
  test::expect_near(take_pose(in), pose, 0.0);
}

TEST(PoseBytes, AreRefusedWhereNoVehicleEverWas) {
  for (const Eigen::Vector3d& pose : {Eigen::Vector3d(2e9, 0.0, 0.0),
                                      {0.0, test::kNaN, 0.0},
                                      {0.0, 0.0, 7.0},
                                      {0.0, 0.0, test::kNaN}}) {
    ByteWriter out;
    for (Eigen::Index i = 0; i < 3; ++i) out.f64(pose[i]);
    ByteReader in(out.bytes(), 0, out.bytes().size());
    EXPECT_THROW(take_pose(in), std::runtime_error) << pose.transpose();
  }
}

}  // namespace
}  // namespace falko_slam
