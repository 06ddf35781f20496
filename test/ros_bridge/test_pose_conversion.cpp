// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/pose_conversion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

const double kAngles[] = {0.0, 1e-9, -1e-9, kPi, -kPi, kPi - 1e-9, -kPi + 1e-9, 3.0 * kPi, 0.7};

Eigen::Quaterniond rotation(const geometry_msgs::Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

TEST(PoseConversion, TurnsPointsAsThePoseDoes) {
  for (const double angle : kAngles) {
    const Pose2 pose(1.0, -2.0, angle);
    const geometry_msgs::Pose message = to_message(pose);
    const Eigen::Quaterniond q = rotation(message.orientation);
    EXPECT_NEAR(q.norm(), 1.0, 1e-12) << angle;
    const Eigen::Vector3d turned = q * Eigen::Vector3d(3.0, 0.5, 0.25);
    const Eigen::Vector2d expected = pose * Eigen::Vector2d(3.0, 0.5);
    EXPECT_NEAR(turned.x() + message.position.x, expected.x(), 1e-12) << angle;
    EXPECT_NEAR(turned.y() + message.position.y, expected.y(), 1e-12) << angle;
    EXPECT_NEAR(turned.z() + message.position.z, 0.25, 1e-12) << angle;
  }
}

TEST(PoseConversion, ATransformIsThePoseOfTheChildInTheParent) {
  const Pose2 pose(1.0, -2.0, 0.7);
  const auto message =
      to_transform(pose, Time(std::chrono::milliseconds(1500)), "odom", "base_link");
  ASSERT_EQ(message.transforms.size(), 1U);
  const geometry_msgs::TransformStamped& transform = message.transforms[0];
  EXPECT_EQ(transform.header.frame_id, "odom");
  EXPECT_EQ(transform.child_frame_id, "base_link");
  EXPECT_EQ(transform.header.stamp, ros::Time(1, 500000000));
  EXPECT_EQ(transform.transform.translation.x, 1.0);
  EXPECT_EQ(transform.transform.translation.y, -2.0);
  EXPECT_EQ(transform.transform.translation.z, 0.0);
  EXPECT_EQ(transform.transform.rotation, to_message(pose).orientation);
}

TEST(PoseConversion, PutsTheCovarianceOfThePlaneIntoThatOfSpace) {
  PoseEstimate estimate;
  estimate.pose = {1.0, 2.0, 0.3};
  estimate.covariance << 1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 3.0;
  const geometry_msgs::PoseWithCovariance message = to_message(estimate);
  EXPECT_EQ(message.pose, to_message(estimate.pose));
  const std::map<std::size_t, double> expected = {
      {0, 1.0}, {1, 0.1}, {5, 0.2}, {6, 0.1}, {7, 2.0}, {11, 0.3}, {30, 0.2}, {31, 0.3}, {35, 3.0}};
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(message.covariance[i], expected.count(i) > 0 ? expected.at(i) : 0.0) << i;
  }
}

geometry_msgs::Transform transform_of(const Eigen::Quaterniond& q) {
  geometry_msgs::Transform transform;
  transform.translation.x = 4.0;
  transform.translation.y = 5.0;
  transform.translation.z = 6.0;
  transform.rotation.w = q.w();
  transform.rotation.x = q.x();
  transform.rotation.y = q.y();
  transform.rotation.z = q.z();
  return transform;
}

TEST(PoseConversion, FindsThePoseInThePlaneUprightOrUpsideDown) {
  const Eigen::Quaterniond down(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  for (const double angle : kAngles) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    for (const bool upside_down : {false, true}) {
      const auto transform = transform_of(upside_down ? turn * down : turn);
      EXPECT_EQ(turns_upside_down(transform), upside_down);
      const Pose2 pose = in_plane(transform);
      EXPECT_EQ(pose.translation(), Eigen::Vector2d(4.0, 5.0));
      EXPECT_NEAR(wrap_angle(pose.theta() - angle), 0.0, 1e-9) << angle;
    }
  }
}

}  // namespace
}  // namespace falko_slam
