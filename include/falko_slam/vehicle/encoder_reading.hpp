// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "falko_slam/common/time.hpp"

namespace falko_slam {

/// The counters of a tricycle's two encoders at one instant.
struct EncoderReading {
  Time stamp{};
  std::uint32_t drive_ticks = 0;  ///< incremental; goes on at 0 after 2^32 - 1
  std::uint32_t steer_ticks = 0;  ///< absolute, of one turn of the steering encoder
};

/// How the steering encoder counts.
struct EncoderParams {
  std::uint32_t steer_ticks_per_turn = 65536;
  std::uint32_t steer_zero = 0;  ///< reading of a wheel that looks straight ahead
  /// Turn of the wheel per turn of the encoder, less than 1 behind a gear; then the encoder tells
  /// apart no more than this share of a turn of the wheel. (0, 2]
  double steer_gain = 1.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const EncoderParams& params);

/// Ticks that the driven wheel turned between two readings, right as long as it were less than
/// 2^31.
std::int32_t ticks_between(std::uint32_t earlier, std::uint32_t later);

/// Measured steering [rad], counter-clockwise, in [-pi, pi) times steer_gain: readings from half a
/// turn of the encoder on mean a wheel turned clockwise, readings beyond a turn wrap.
double steering_of(const EncoderParams& params, std::uint32_t steer_ticks);

/// How far the wheel was turned between two readings, the shorter way round the encoder [rad]. To
/// be added to the earlier steering without wrapping.
double steering_between(const EncoderParams& params, std::uint32_t earlier, std::uint32_t later);

/// The nearest reading of a steering [rad].
std::uint32_t steer_ticks_of(const EncoderParams& params, double steering);

}  // namespace falko_slam
