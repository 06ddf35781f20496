// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/encoder_reading.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void validate(const EncoderParams& params) {
  constexpr std::uint32_t kMost = 1U << 30U;
  require_in_range("steer_ticks_per_turn", params.steer_ticks_per_turn, 4U, kMost);
  require_in_range("steer_zero", params.steer_zero, 0U, params.steer_ticks_per_turn - 1);
}

std::int32_t ticks_between(std::uint32_t earlier, std::uint32_t later) {
  return static_cast<std::int32_t>(later - earlier);
}

double steering_of(const EncoderParams& params, std::uint32_t steer_ticks) {
  const double turn = params.steer_ticks_per_turn;
  const double from_zero =
      static_cast<double>(steer_ticks) - static_cast<double>(params.steer_zero);
  return wrap_angle(kTwoPi * from_zero / turn);
}

std::uint32_t steer_ticks_of(const EncoderParams& params, double steering) {
  const double turn = params.steer_ticks_per_turn;
  const double ticks = std::round(steering / kTwoPi * turn) + params.steer_zero;
  return static_cast<std::uint32_t>(ticks - turn * std::floor(ticks / turn));
}

}  // namespace falko_slam
