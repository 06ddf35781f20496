// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

/// Turns readings of encoders into motions, as a vehicle's software does.
class MotionSource {
 public:
  MotionSource(const TricycleParams& tricycle, const EncoderParams& encoders,
               const OdometryNoise& noise)
      : tricycle_(tricycle), noise_(noise), odometry_(tricycle, encoders) {}

  /// Of base_link since the reading before; nothing of the first one.
  std::optional<PoseEstimate> add(const EncoderReading& reading) {
    const Pose2 before = odometry_.odom_T_base();
    const OdometryStep step = odometry_.add(reading);
    if (step.verdict != OdometryVerdict::kIntegrated) return std::nullopt;
    return PoseEstimate{before.inverse() * odometry_.odom_T_base(),
                        arc_covariance(tricycle_, step.ticks, step.steering, noise_)};
  }

 private:
  TricycleParams tricycle_;
  OdometryNoise noise_;
  TricycleOdometry odometry_;
};

}  // namespace falko_slam
