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
  std::uint32_t steer_ticks = 0;  ///< absolute, of one turn of the steering axis
};

/// How the steering encoder counts.
struct EncoderParams {
  std::uint32_t steer_ticks_per_turn = 65536;
  std::uint32_t steer_zero = 0;  ///< reading of a wheel that looks straight ahead
};
/// Throws std::invalid_argument with the field and its value.
void validate(const EncoderParams& params);

/// Ticks that the driven wheel turned between two readings, right as long as it were less than
/// 2^31.
std::int32_t ticks_between(std::uint32_t earlier, std::uint32_t later);

/// Measured steering in [-pi, pi) [rad], counter-clockwise; readings beyond a turn wrap.
double steering_of(const EncoderParams& params, std::uint32_t steer_ticks);

/// The nearest reading of a steering [rad].
std::uint32_t steer_ticks_of(const EncoderParams& params, double steering);

}  // namespace falko_slam
