// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "fuzz/input_numbers.hpp"

namespace falko_slam {
namespace fuzz {

/// A message of a laser scanner with whatever numbers the input holds.
struct InputScan {
  std::vector<float> ranges;
  std::vector<float> intensities;
  RawScan fields;  ///< all but the arrays

  /// Borrows the arrays.
  RawScan raw() const {
    RawScan raw = fields;
    raw.ranges = ranges.data();
    raw.range_count = ranges.size();
    raw.intensities = intensities.data();
    raw.intensity_count = intensities.size();
    return raw;
  }
};

/// Millimetres, or what no range should be.
inline float any_range(InputNumbers& numbers) {
  const auto code = numbers.any<std::uint16_t>();
  if (code < 0xFFF0U) return 0.001F * static_cast<float>(code);
  if (code < 0xFFF4U) return std::numeric_limits<float>::infinity();
  if (code < 0xFFF8U) return std::numeric_limits<float>::quiet_NaN();
  if (code < 0xFFFAU) return -std::numeric_limits<float>::infinity();
  return numbers.any<float>();
}

/// Stamps as a ROS message can hold them.
inline Time any_stamp(InputNumbers& numbers) {
  const auto seconds = numbers.any<std::uint32_t>();
  const auto nanoseconds = numbers.any<std::uint32_t>();
  return Time(std::chrono::seconds(seconds) + std::chrono::nanoseconds(nanoseconds));
}

/// One of the fields of a message, which are single precision, replaced by anything.
inline void change_any_field(RawScan& raw, InputNumbers& numbers) {
  double* const fields[] = {&raw.angle_min,      &raw.angle_max, &raw.angle_increment,
                            &raw.time_increment, &raw.scan_time, &raw.range_min,
                            &raw.range_max};
  *fields[numbers.below(7)] = static_cast<double>(numbers.any<float>());
}

inline InputScan any_scan(InputNumbers& numbers, std::size_t most_beams) {
  InputScan scan;
  scan.ranges.resize(numbers.below(most_beams + 1));
  const std::size_t changes = numbers.below(4);
  const std::size_t bright = numbers.below(3);  // intensities: none, too few, all
  const double width = numbers.coin() ? kTwoPi : 1.5 * kPi;
  scan.fields.angle_min = -0.5 * width;
  scan.fields.angle_max = 0.5 * width;
  scan.fields.angle_increment =
      width / static_cast<double>(std::max<std::size_t>(1, scan.ranges.size()));
  scan.fields.time_increment = 8.7e-5;
  scan.fields.range_max = 100.0;
  scan.fields.stamp = Time(std::chrono::seconds(1000));
  for (std::size_t i = 0; i < changes; ++i) change_any_field(scan.fields, numbers);
  scan.intensities.resize(scan.ranges.size() * bright / 2);
  for (float& range : scan.ranges) range = any_range(numbers);
  for (float& intensity : scan.intensities) intensity = any_range(numbers);
  return scan;
}

}  // namespace fuzz
}  // namespace falko_slam
