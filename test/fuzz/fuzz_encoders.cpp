// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is done with every message of encoders.
#include "falko_slam/vehicle/tricycle_odometry.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/input_scan.hpp"

void falko_slam::fuzz::fuzz_encoders(const std::string& input) {
  InputNumbers numbers(input);
  EncoderParams encoders;
  encoders.steer_zero = numbers.any<std::uint16_t>();
  encoders.steer_gain = 1.0 + numbers.within(0.99);
  TricycleOdometryParams params;
  params.max_wheel_speed = static_cast<double>(numbers.below(101));
  TricycleOdometry odometry(TricycleParams{}, encoders, {}, params);
  while (!numbers.ended()) {
    const Time stamp = any_stamp(numbers);
    odometry.add({stamp, numbers.any<std::uint32_t>(), numbers.any<std::uint32_t>()});
    if (numbers.below(16) == 0) odometry.restart();
    const Pose2& pose = odometry.odom_T_base();
    require(pose.translation().allFinite() && std::isfinite(pose.theta()), "the pose is finite");
  }
}
