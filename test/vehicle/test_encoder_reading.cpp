// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/encoder_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();

EncoderParams params_of(std::uint32_t ticks_per_turn, std::uint32_t zero, double gain = 1.0) {
  EncoderParams params;
  params.steer_ticks_per_turn = ticks_per_turn;
  params.steer_zero = zero;
  params.steer_gain = gain;
  return params;
}

const EncoderParams kEncoders[] = {params_of(65536, 0),     params_of(8192, 8191),
                                   params_of(3601, 17),     params_of(5, 3),
                                   params_of(8192, 0, 0.1), params_of(3601, 3600, 0.25)};

TEST(DriveTicks, GoOnOverTheirEndBothWays) {
  EXPECT_EQ(ticks_between(kLast - 2, 4), 7);
  EXPECT_EQ(ticks_between(4, kLast - 2), -7);
  EXPECT_EQ(ticks_between(0, kLast), -1);
  EXPECT_EQ(ticks_between(kLast, 0), 1);
  EXPECT_EQ(ticks_between(7, 7), 0);
}

TEST(DriveTicks, AreRightUpToHalfOfWhatTheCounterHolds) {
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  for (const std::uint32_t start : {0U, 1U, 1U << 31U, kLast - 1, kLast}) {
    EXPECT_EQ(ticks_between(start, start + static_cast<std::uint32_t>(kMost)), kMost);
    EXPECT_EQ(ticks_between(start, start - static_cast<std::uint32_t>(kMost)), -kMost);
  }
}

TEST(Steering, IsCountedCounterClockwiseFromTheZero) {
  const EncoderParams params = params_of(8192, 100);
  EXPECT_EQ(steering_of(params, 100), 0.0);
  EXPECT_NEAR(steering_of(params, 100 + 2048), kPi / 2.0, 1e-15);
  EXPECT_NEAR(steering_of(params, 100 + 8192 - 2048), -kPi / 2.0, 1e-15);
  EXPECT_NEAR(steering_of(params, 99), -kTwoPi / 8192, 1e-15);
}

TEST(Steering, FromHalfATurnOnIsClockwise) {
  const EncoderParams params = params_of(8192, 0);
  EXPECT_EQ(steering_of(params, 4096), -kPi);
  EXPECT_NEAR(steering_of(params, 4095), kPi - kTwoPi / 8192, 1e-14);
  EXPECT_NEAR(steering_of(params, 8191), -kTwoPi / 8192, 1e-14);
}

TEST(Steering, OfReadingsBeyondATurnIsThatWithinIt) {
  for (const EncoderParams& params : kEncoders) {
    for (std::uint32_t ticks = 0; ticks < 5; ++ticks) {
      EXPECT_EQ(steering_of(params, ticks + 7 * params.steer_ticks_per_turn),
                steering_of(params, ticks));
    }
    EXPECT_LE(std::abs(steering_of(params, kLast)), kPi * params.steer_gain);
  }
}

TEST(Steering, BehindAGearIsAShareOfTheEncodersTurn) {
  const EncoderParams geared = params_of(8192, 30, 0.1);
  const EncoderParams direct = params_of(8192, 30);
  for (const std::uint32_t ticks : {0U, 29U, 30U, 500U, 4125U, 4126U, 8191U}) {
    EXPECT_NEAR(steering_of(geared, ticks), 0.1 * steering_of(direct, ticks), 1e-15) << ticks;
  }
}

TEST(Steering, ComesBackAsItsReading) {
  for (const EncoderParams& params : kEncoders) {
    for (std::uint32_t ticks = 0; ticks < params.steer_ticks_per_turn; ++ticks) {
      ASSERT_EQ(steer_ticks_of(params, steering_of(params, ticks)), ticks)
          << params.steer_ticks_per_turn << " ticks per turn";
    }
  }
}

TEST(Steering, FindsTheNearestReading) {
  auto random = test::seeded_random();
  for (const EncoderParams& params : kEncoders) {
    const double tick = kTwoPi / params.steer_ticks_per_turn * params.steer_gain;
    for (int i = 0; i < 1000; ++i) {
      const double steering = params.steer_gain * test::uniform(random, -3.0 * kPi, 3.0 * kPi);
      const std::uint32_t ticks = steer_ticks_of(params, steering);
      EXPECT_LT(ticks, params.steer_ticks_per_turn);
      const double away = (steering_of(params, ticks) - steering) / params.steer_gain;
      EXPECT_LE(std::abs(wrap_angle(away)) * params.steer_gain, 0.5 * tick + 1e-12);
    }
  }
}

TEST(Steering, ChangesTheShorterWay) {
  const EncoderParams params = params_of(8192, 500);
  const double tick = kTwoPi / 8192;
  EXPECT_NEAR(steering_between(params, 8190, 3), 5 * tick, 1e-15);
  EXPECT_NEAR(steering_between(params, 3, 8190), -5 * tick, 1e-15);
  // Past the direction straight back, where the steering itself jumps by a turn.
  EXPECT_NEAR(steering_between(params, 4595, 4597), 2 * tick, 1e-15);
  EXPECT_GT(std::abs(steering_of(params, 4597) - steering_of(params, 4595)), kPi);
}

TEST(Steering, OfTheLaterReadingIsTheEarlierOneAndTheChange) {
  auto random = test::seeded_random();
  for (const EncoderParams& params : kEncoders) {
    std::uniform_int_distribution<std::uint32_t> reading(0, params.steer_ticks_per_turn - 1);
    for (int i = 0; i < 1000; ++i) {
      const std::uint32_t earlier = reading(random);
      const std::uint32_t later = reading(random);
      const double change = steering_between(params, earlier, later);
      EXPECT_LE(std::abs(change), kPi * params.steer_gain + 1e-12);
      EXPECT_EQ(steer_ticks_of(params, steering_of(params, earlier) + change), later);
    }
  }
}

TEST(EncoderParameters, AreRefusedWithTheirNames) {
  const auto error_of = [](const EncoderParams& params) -> std::string {
    try {
      validate(params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  for (const EncoderParams& params : kEncoders) {
    EXPECT_EQ(error_of(params), "no error");
  }
  EXPECT_EQ(error_of(params_of(0, 0)).find("steer_ticks_per_turn = 0:"), 0U);
  EXPECT_EQ(error_of(params_of(3, 0)).find("steer_ticks_per_turn = 3:"), 0U);
  EXPECT_EQ(error_of(params_of(kLast, 0)).find("steer_ticks_per_turn = "), 0U);
  EXPECT_EQ(error_of(params_of(8192, 8192)).find("steer_zero = 8192:"), 0U);
  EXPECT_EQ(error_of(params_of(8192, 0, 0.0)).find("steer_gain = 0:"), 0U);
  EXPECT_EQ(error_of(params_of(8192, 0, -0.1)).find("steer_gain = -0.1:"), 0U);
  EXPECT_EQ(error_of(params_of(8192, 0, 2.5)).find("steer_gain = 2.5:"), 0U);
  EXPECT_EQ(error_of(params_of(8192, 0, std::nan(""))).find("steer_gain = nan:"), 0U);
}

}  // namespace
}  // namespace falko_slam
