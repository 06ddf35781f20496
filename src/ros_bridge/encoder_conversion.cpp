// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/encoder_conversion.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

// Within `limit` of zero [rad]; NaN is not.
std::optional<double> position_of(const sensor_msgs::JointState& message, const char* joint,
                                  double limit) {
  const auto found = std::find(message.name.begin(), message.name.end(), joint);
  const auto index = static_cast<std::size_t>(found - message.name.begin());
  if (found == message.name.end() || index >= message.position.size()) return std::nullopt;
  const double position = message.position[index];
  return std::abs(position) <= limit ? std::optional<double>(position) : std::nullopt;
}

}  // namespace

TricycleEncoders to_message(const EncoderReading& reading, const std::string& frame) {
  TricycleEncoders message;
  message.header.stamp = to_ros(reading.stamp);
  message.header.frame_id = frame;
  message.drive_ticks = reading.drive_ticks;
  message.steer_ticks = reading.steer_ticks;
  return message;
}

EncoderReading from_message(const TricycleEncoders& message) {
  return {from_ros(message.header.stamp), message.drive_ticks, message.steer_ticks};
}

void validate(const JointParams& params) {
  validate(params.encoders);
  require_in_range("drive_ticks_per_turn", params.drive_ticks_per_turn, 1U, 1U << 30U);
}

JointStateSource::JointStateSource(const JointParams& params) : params_(params) {
  validate(params_);
}

sensor_msgs::JointState JointStateSource::next(const EncoderReading& reading) {
  drive_ticks_ = last_ ? drive_ticks_ + ticks_between(*last_, reading.drive_ticks)
                       : std::int64_t{reading.drive_ticks};
  last_ = reading.drive_ticks;
  sensor_msgs::JointState message;
  message.header.stamp = to_ros(reading.stamp);
  message.name = {kSteerJoint, kDriveJoint};
  message.position = {steering_of(params_.encoders, reading.steer_ticks),
                      kTwoPi * static_cast<double>(drive_ticks_) / params_.drive_ticks_per_turn};
  return message;
}

std::optional<EncoderReading> from_message(const sensor_msgs::JointState& message,
                                           const JointParams& params) {
  constexpr double kMostTicks = 4503599627370496.0;  // 2^52: a double tells all of them apart
  const double turn = params.drive_ticks_per_turn;
  const auto steering =
      position_of(message, kSteerJoint, 1e6 * kTwoPi * params.encoders.steer_gain);
  const auto drive = position_of(message, kDriveJoint, kMostTicks / turn * kTwoPi);
  if (!steering || !drive) return std::nullopt;
  // The counter is the sum modulo 2^32.
  const auto ticks = static_cast<std::int64_t>(std::round(*drive / kTwoPi * turn));
  return EncoderReading{from_ros(message.header.stamp), static_cast<std::uint32_t>(ticks),
                        steer_ticks_of(params.encoders, *steering)};
}

}  // namespace falko_slam
