// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "slam_client.hpp"

namespace falko_slam {

using test::LoadedSlam;
using test::pose_of;
using test::SlamClient;
using test::spin_until;
constexpr int kOk = diagnostic_msgs::DiagnosticStatus::OK;
constexpr int kWarn = diagnostic_msgs::DiagnosticStatus::WARN;

constexpr double kStep = 0.25;
const Pose2 kStart{20.0, -7.0, 1.0};  // where the odometry has the office's frame

/// Round the office, with an odometry that drifts.
class Way {
 public:
  explicit Way(const Pose2& odom_T_world = kStart, std::size_t first = 0)
      : lap_(office_path(kStep)), first_(first), odometry_(odom_T_world * truth(0)) {}

  Pose2 truth(std::size_t i) const { return lap_[(first_ + i) % lap_.size()]; }
  std::size_t lap() const { return lap_.size(); }
  std::size_t driven() const { return driven_; }
  const Pose2& odometry() const { return odometry_; }
  void drive(SlamClient& client, std::size_t steps) {
    for (std::size_t i = 0; i < steps; ++i, ++driven_) {
      if (driven_ > 0) {
        const Pose2 step = truth(driven_ - 1).inverse() * truth(driven_);
        odometry_ = odometry_ * Pose2(1.01 * step.translation(), step.theta() + 0.001);
      }
      client.step(truth(driven_), odometry_);
    }
  }
  Pose2 here() const { return truth(driven_ - 1); }

 private:
  std::vector<Pose2> lap_;
  std::size_t first_;
  std::size_t driven_ = 0;
  Pose2 odometry_;
};

inline bool all_came(SlamClient& client) {
  return spin_until(
      [&] { return !client.poses.empty() && client.last_pose().header.stamp == client.stamp; });
}
inline double error_of(const SlamClient& client, const Pose2& expected) {
  return (expected.inverse() * pose_of(client.last_pose().pose.pose)).translation().norm();
}
inline void expect_stamps_rise(const std::vector<geometry_msgs::TransformStamped>& transforms) {
  for (std::size_t i = 1; i < transforms.size(); ++i) {
    EXPECT_LT(transforms[i - 1].header.stamp, transforms[i].header.stamp) << i;
  }
}

}  // namespace falko_slam
