// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/laser_model.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

constexpr double kFar = 1000.0;      // [m]
constexpr double kQuotients = 1e-9;  // of quotients like 2 pi / 1440

void validate_beams(const LaserModel& laser) {
  require_in_range<std::size_t>("beams", laser.beams, 2, 100000);
  const auto beams = static_cast<double>(laser.beams);
  require_in_range("angle_min", laser.angle_min, -kTwoPi, kTwoPi);
  const double most = kTwoPi / (beams - 1.0) * (1.0 + kQuotients);
  require_in_range("angle_increment", laser.angle_increment, -most, most);
  require_in_range("angle_increment without sign", std::abs(laser.angle_increment), 1e-6, most);
  require_in_range("scan_period", laser.scan_period, 1e-3, 60.0);
  require_in_range("time_increment", laser.time_increment, 0.0,
                   laser.scan_period / beams * (1.0 + kQuotients));
}

void validate_optics(const LaserModel& laser) {
  require_in_range("nearest", laser.nearest, 0.0, kFar);
  require_in_range("farthest", laser.farthest, laser.nearest, kFar);
  require_in_range("range_of_dark", laser.range_of_dark, 0.1, kFar);
  require_in_range("beam_diameter", laser.beam_diameter, 0.0, 1.0);
  require_in_range("beam_divergence", laser.beam_divergence, 0.0, 0.1);
  require_in_range("echo_separation", laser.echo_separation, 0.0, 10.0);
}

void validate_errors(const LaserModel& laser) {
  require_in_range("range_noise", laser.range_noise, 0.0, 1.0);
  require_in_range("range_step", laser.range_step, 0.0, 1.0);
  require_in_range("bearing_noise", laser.bearing_noise, 0.0, 0.1);
  require_in_range("drop_out", laser.drop_out, 0.0, 1.0);
}

}  // namespace

void validate(const LaserModel& laser) {
  validate_beams(laser);
  validate_optics(laser);
  validate_errors(laser);
  require_in_range("white_intensity", laser.white_intensity, 0.0, 1e9);
  require_in_range("intensity_exponent", laser.intensity_exponent, 0.01, 2.0);
  require_in_range("stated_range_min", laser.stated_range_min, 0.0, kFar);
  require_in_range("stated_range_max", laser.stated_range_max, laser.stated_range_min, kFar);
}

Duration sweep_of(const LaserModel& laser) {
  return from_seconds(static_cast<double>(laser.beams - 1) * laser.time_increment);
}

LaserModel s300() {
  LaserModel laser;
  laser.beams = 541;
  laser.angle_min = degrees_to_radians(-135.0);
  laser.angle_increment = degrees_to_radians(0.5);
  laser.scan_period = 0.04;
  laser.time_increment = 0.04 / 720.0;  // its mirror turns all the way round
  laser.nearest = 0.05;
  laser.farthest = 30.0;
  laser.range_of_dark = 10.0;
  laser.beam_diameter = 0.008;
  laser.beam_divergence = 0.014;
  laser.range_noise = 0.010;
  laser.range_step = 0.010;
  laser.bearing_noise = 1e-3;
  laser.intensities = false;
  laser.stated_range_min = 0.001;
  laser.stated_range_max = 30.0;
  return laser;
}

}  // namespace falko_slam
