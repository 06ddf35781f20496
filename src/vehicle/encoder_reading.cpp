// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/encoder_reading.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Wrapped in ticks, where it is exact.
double angle_of(const EncoderParams& params, double ticks) {
  const double turn = params.steer_ticks_per_turn;
  const double within_a_turn = ticks - turn * std::floor(ticks / turn + 0.5);
  return kTwoPi * within_a_turn / turn * params.steer_gain;
}

double as_number(std::uint32_t ticks) { return static_cast<double>(ticks); }

}  // namespace

void validate(const EncoderParams& params) {
  constexpr std::uint32_t kMost = 1U << 30U;
  require_in_range("steer_ticks_per_turn", params.steer_ticks_per_turn, 4U, kMost);
  require_in_range("steer_zero", params.steer_zero, 0U, params.steer_ticks_per_turn - 1);
  require_in_range("steer_gain", params.steer_gain, 1e-4, 2.0);
}

std::int32_t ticks_between(std::uint32_t earlier, std::uint32_t later) {
  return static_cast<std::int32_t>(later - earlier);
}

double steering_of(const EncoderParams& params, std::uint32_t steer_ticks) {
  return angle_of(params, as_number(steer_ticks) - as_number(params.steer_zero));
}

double steering_between(const EncoderParams& params, std::uint32_t earlier, std::uint32_t later) {
  return angle_of(params, as_number(later) - as_number(earlier));
}

std::uint32_t steer_ticks_of(const EncoderParams& params, double steering) {
  const double turn = params.steer_ticks_per_turn;
  const double ticks = std::round(steering / kTwoPi / params.steer_gain * turn) + params.steer_zero;
  return static_cast<std::uint32_t>(ticks - turn * std::floor(ticks / turn));
}

}  // namespace falko_slam
