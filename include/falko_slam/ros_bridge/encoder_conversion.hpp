// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/TricycleEncoders.h>
#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <optional>
#include <string>

#include "falko_slam/vehicle/encoder_reading.hpp"

namespace falko_slam {

TricycleEncoders to_message(const EncoderReading& reading, const std::string& frame);
EncoderReading from_message(const TricycleEncoders& message);

constexpr char kSteerJoint[] = "steer_joint";  ///< the steering measured, counter-clockwise [rad]
constexpr char kDriveJoint[] = "drive_joint";  ///< what the drive encoder turned, forward [rad]

/// How the joints of a JointState are counted.
struct JointParams {
  EncoderParams encoders;
  /// Of the drive encoder, per turn of the drive joint: of the wheel itself if there is no gear
  /// between, or this is that many times more.
  std::uint32_t drive_ticks_per_turn = 5000;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const JointParams& params);

/// The positions of both joints, reading by reading. That of the drive joint starts with what the
/// counter holds and goes on over its end, so that it never jumps.
class JointStateSource {
 public:
  /// Throws std::invalid_argument with the field and its value.
  explicit JointStateSource(const JointParams& params);

  sensor_msgs::JointState next(const EncoderReading& reading);

 private:
  JointParams params_;
  std::optional<std::uint32_t> last_;
  std::int64_t drive_ticks_ = 0;
};

/// The nearest counters, whatever else the message holds: the inverse of JointStateSource. Empty if
/// one of the joints is missing, has no position, or one that is not finite or beyond any counter
/// (1e6 turns for the steering, 2^52 ticks for the drive).
std::optional<EncoderReading> from_message(const sensor_msgs::JointState& message,
                                           const JointParams& params);

}  // namespace falko_slam
