// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/reflector_report.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

constexpr double kBrighter = 1.6;    // than a white surface at the same range
constexpr double kSameRange = 0.25;  // between neighbours [m]

double power_of(const LaserModel& laser, float intensity) {
  return std::pow(static_cast<double>(intensity) / laser.white_intensity,
                  1.0 / laser.intensity_exponent);
}

bool is_bright(const LaserModel& laser, const SimulatedScan& scan, std::size_t beam) {
  const auto range = static_cast<double>(scan.ranges[beam]);
  if (range <= 0.0) return false;
  const double white = laser.white_intensity * std::pow(range, -2.0 * laser.intensity_exponent);
  return static_cast<double>(scan.intensities[beam]) > kBrighter * white;
}

bool belong_together(const LaserModel& laser, const SimulatedScan& scan, std::size_t a,
                     std::size_t b) {
  return is_bright(laser, scan, a) && is_bright(laser, scan, b) &&
         std::abs(scan.ranges[a] - scan.ranges[b]) <= kSameRange;
}

bool covers_circle(const LaserModel& laser) {
  return std::abs(laser.angle_increment) * static_cast<double>(laser.beams) >
         kTwoPi - 0.5 * std::abs(laser.angle_increment);
}

ReflectorDetection detection_of(const LaserModel& laser, const SimulatedScan& scan,
                                std::size_t first, std::size_t hits, double diameter) {
  ReflectorDetection found;
  found.first_beam = first;
  found.last_beam = (first + hits - 1) % laser.beams;
  found.hits = hits;
  double power = 0.0, range = 0.0, nth = 0.0;
  for (std::size_t i = 0; i < hits; ++i) {
    const std::size_t beam = (first + i) % laser.beams;
    const double weight = power_of(laser, scan.intensities[beam]);
    power += weight;
    range += weight * static_cast<double>(scan.ranges[beam]);
    nth += weight * static_cast<double>(i);
    found.mean_intensity += static_cast<double>(scan.intensities[beam]) / static_cast<double>(hits);
  }
  // The mean depth of the front of a cylinder that is lit evenly is pi / 4 of its radius.
  found.range = range / power + 0.125 * kPi * diameter;
  const double middle = static_cast<double>(first) + nth / power;
  found.bearing = wrap_angle(laser.angle_min + middle * laser.angle_increment);
  found.time_offset = laser.time_increment * std::fmod(middle, static_cast<double>(laser.beams));
  return found;
}

}  // namespace

std::vector<ReflectorDetection> report_reflectors(const LaserModel& laser,
                                                  const SimulatedScan& scan, double diameter) {
  std::vector<ReflectorDetection> found;
  const std::size_t beams = scan.ranges.size();
  if (scan.intensities.size() != beams || beams < 2) return found;
  const bool circle = covers_circle(laser);
  const auto joined = [&](std::size_t beam) {  // with the one before
    return beam > 0 ? belong_together(laser, scan, beam - 1, beam)
                    : circle && belong_together(laser, scan, beams - 1, 0);
  };
  for (std::size_t first = 0; first < beams; ++first) {
    if (!is_bright(laser, scan, first) || joined(first)) continue;
    std::size_t hits = 1;
    while (hits < beams && first + hits < (circle ? first + beams : beams) &&
           joined((first + hits) % beams)) {
      ++hits;
    }
    found.push_back(detection_of(laser, scan, first, hits, diameter));
  }
  return found;
}

}  // namespace falko_slam
