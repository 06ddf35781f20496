// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/scan_normalizer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Larger angles are no bearings of a scanner but garbage that would only lose precision.
constexpr double kMaxAngle = 100.0;

// No scanner has beams so near each other; keeps their count over a turn a number. [rad]
constexpr double kMinIncrement = 1e-6;

// No scanner sees farther; keeps arithmetic on ranges safe where range_max is unlimited. [m]
constexpr double kMaxRange = 1e5;

struct RangeLimits {
  double min;
  double max;
};

RangeLimits range_limits(const RawScan& raw, const ScanNormalizerParams& params) {
  RangeLimits limits{std::isfinite(raw.range_min) ? std::max(0.0, raw.range_min) : 0.0,
                     raw.range_max > 0.0 ? std::min(raw.range_max, kMaxRange) : kMaxRange};
  limits.min = std::max(limits.min, params.min_range);
  if (params.max_range > 0.0) limits.max = std::min(limits.max, params.max_range);
  return limits;
}

BeamStatus classify(float range, const RangeLimits& limits, bool zero_is_no_return) {
  if (std::isnan(range)) return BeamStatus::kErroneous;
  if (range == 0.0F) return zero_is_no_return ? BeamStatus::kNoReturn : BeamStatus::kZero;
  if (range < 0.0F || range < limits.min) return BeamStatus::kTooNear;
  if (std::isinf(range)) return BeamStatus::kNoReturn;
  return range > limits.max ? BeamStatus::kTooFar : BeamStatus::kValid;
}

bool plausible(double angle) { return std::abs(angle) <= kMaxAngle; }  // false for NaN

bool plausible_increment(double angle) {
  return plausible(angle) && std::abs(angle) >= kMinIncrement;
}

// The stated increment, or the one that spreads the beams from angle_min to angle_max.
double angle_increment(const RawScan& raw, ScanReport& report) {
  if (plausible_increment(raw.angle_increment)) return raw.angle_increment;
  if (raw.range_count < 2 || !plausible(raw.angle_max)) return 0.0;
  report.angle_increment_derived = true;
  const double derived = (raw.angle_max - raw.angle_min) / static_cast<double>(raw.range_count - 1);
  return plausible_increment(derived) ? derived : 0.0;
}

// Longer than a scanner ever needs: such a time is an error of the driver.
constexpr double kMaxScanTime = 60.0;

bool plausible_time(double seconds) { return seconds > 0.0 && seconds < kMaxScanTime; }

// A rotating mirror passes the whole circle in scan_time, the blind sector included.
double time_increment(const RawScan& raw, double angle_increment, ScanReport& report) {
  const auto beams = static_cast<double>(raw.range_count);
  if (plausible_time(raw.time_increment * beams)) return raw.time_increment;
  if (!plausible_time(raw.scan_time)) return 0.0;
  report.time_increment_derived = true;
  return raw.scan_time * std::abs(angle_increment) / kTwoPi;
}

std::size_t beams_of_a_turn(double angle_increment) {
  if (angle_increment == 0.0) return std::numeric_limits<std::size_t>::max();
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(kTwoPi / std::abs(angle_increment))));
}

Duration stamp_offset(ScanNormalizerParams::StampAt stamp_at, std::size_t beams, double increment) {
  const double last = static_cast<double>(beams - 1) * increment;
  switch (stamp_at) {
    case ScanNormalizerParams::StampAt::kMiddleBeam:
      return from_seconds(0.5 * last);
    case ScanNormalizerParams::StampAt::kLastBeam:
      return from_seconds(last);
    case ScanNormalizerParams::StampAt::kFirstBeam:
      break;
  }
  return Duration::zero();
}

void copy_ranges(const RawScan& raw, const ScanNormalizerParams& params, LaserScan& scan,
                 ScanReport& report) {
  const RangeLimits limits = range_limits(raw, params);
  scan.range_max = limits.max;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const float range = raw.ranges[scan.message_index(i)];
    scan.status[i] = classify(range, limits, params.zero_is_no_return);
    const double corrected = range + params.range_offset;
    if (scan.valid(i) && corrected <= 0.0) scan.status[i] = BeamStatus::kTooNear;
    scan.ranges[i] = scan.valid(i) ? corrected : kNaN;
    ++report.status_count[static_cast<std::size_t>(scan.status[i])];
  }
}

void copy_intensities(const RawScan& raw, LaserScan& scan, ScanReport& report) {
  scan.intensities.resize(raw.intensity_count == 0 ? 0 : scan.size());
  for (std::size_t i = 0; i < scan.intensities.size(); ++i) {
    const std::size_t index = scan.message_index(i);
    const bool present = index < raw.intensity_count;
    scan.intensities[i] =
        present ? raw.intensities[index] : std::numeric_limits<float>::quiet_NaN();
    if (!present) ++report.missing_intensities;
  }
}

ScanReport reject(ScanFault fault, ScanReport report, LaserScan& scan) {
  scan.ranges.clear();
  scan.status.clear();
  scan.intensities.clear();
  report.fault = fault;
  return report;
}

}  // namespace

ScanReport normalize(const RawScan& raw, const ScanNormalizerParams& params, LaserScan& scan) {
  ScanReport report;
  report.beam_count = raw.range_count;
  if (raw.range_count == 0) return reject(ScanFault::kNoBeams, report, scan);
  const double increment = angle_increment(raw, report);
  if (!plausible(raw.angle_min) || (increment == 0.0 && raw.range_count > 1)) {
    return reject(ScanFault::kBadAngles, report, scan);
  }

  const std::size_t turn = beams_of_a_turn(increment);
  const std::size_t beams = std::min(raw.range_count, turn);
  const auto last_beam = static_cast<double>(beams - 1);
  report.surplus_beams = raw.range_count - beams;
  if (increment != 0.0) {
    const double last = raw.angle_min + static_cast<double>(raw.range_count - 1) * increment;
    report.angle_max_excess = (raw.angle_max - last) / increment;
  }

  const double sign = params.upside_down ? -1.0 : 1.0;
  scan.reversed = sign * increment < 0.0;
  scan.closed = beams == turn && beams > 2;
  scan.angle_increment = std::abs(increment);
  scan.angle_min = sign * (raw.angle_min + (scan.reversed ? last_beam * increment : 0.0));
  scan.ranges.resize(beams);
  scan.status.resize(beams);
  // Surplus beams are dropped at the end of the message, so its first `beams` entries remain.
  copy_ranges(raw, params, scan, report);
  copy_intensities(raw, scan, report);

  const double seconds = time_increment(raw, increment, report);
  const Time first = raw.stamp - stamp_offset(params.stamp_at, raw.range_count, seconds);
  scan.first_beam_time = scan.reversed ? first + from_seconds(last_beam * seconds) : first;
  scan.time_increment = from_seconds(scan.reversed ? -seconds : seconds);
  return report;
}

void validate(const ScanNormalizerParams& params) {
  const auto fail = [](const char* field, double value) {
    throw std::invalid_argument(std::string(field) + " = " + std::to_string(value) +
                                ": must be finite and not negative");
  };
  if (!(params.min_range >= 0.0) || std::isinf(params.min_range)) {
    fail("min_range", params.min_range);
  }
  if (!(params.max_range >= 0.0) || std::isinf(params.max_range)) {
    fail("max_range", params.max_range);
  }
  if (!std::isfinite(params.range_offset)) {
    throw std::invalid_argument("range_offset = " + std::to_string(params.range_offset) +
                                ": must be finite");
  }
}

}  // namespace falko_slam
