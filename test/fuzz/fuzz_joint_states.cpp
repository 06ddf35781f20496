// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_numbers.hpp"

void falko_slam::fuzz::fuzz_joint_states(const std::string& input) {
  InputNumbers numbers(input);
  JointParams params;
  params.encoders.steer_gain = 1.0 + numbers.within(0.99);
  params.drive_ticks_per_turn = 1 + numbers.any<std::uint16_t>();
  while (!numbers.ended()) {
    sensor_msgs::JointState message;
    message.header.stamp.sec = numbers.any<std::uint32_t>();
    message.header.stamp.nsec = numbers.any<std::uint32_t>();
    message.name.resize(numbers.below(4), kDriveJoint);
    if (message.name.size() > 1) message.name[numbers.below(message.name.size())] = kSteerJoint;
    message.position.resize(numbers.below(4));
    for (double& position : message.position) {
      position = numbers.any<std::uint8_t>() > 127 ? numbers.any<double>() : numbers.within(1e7);
    }
    from_message(message, params);
  }
}
