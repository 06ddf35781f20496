// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/trajectory_file.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

constexpr std::int64_t kNanoseconds = 1000000000;
constexpr double kMaxSeconds = 9e9;

std::string seconds_text(Time stamp) {
  const std::int64_t count = stamp.time_since_epoch().count();
  const auto magnitude = count < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(count)
                                   : static_cast<std::uint64_t>(count);
  const std::string digits = std::to_string(magnitude % kNanoseconds);
  return (count < 0 ? "-" : "") + std::to_string(magnitude / kNanoseconds) + "." +
         std::string(9 - digits.size(), '0') + digits;
}

// Rounded to 1e-9 and away from the wrap: turns by half a circle come back with the same sign.
double rounded_heading(double theta) {
  constexpr std::int64_t kHalfTurn = 3141592653;
  return 1e-9 * static_cast<double>(
                    std::clamp<std::int64_t>(std::llround(theta * 1e9), -kHalfTurn, kHalfTurn));
}

bool all_digits(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The yaw of a quaternion of any length.
double yaw_of(double x, double y, double z, double w) {
  return std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
}

StampedPose parse_line(const std::string& line, const LineReader& file) {
  std::istringstream in(line);
  in.imbue(std::locale::classic());
  std::string seconds;
  std::string rest;
  double x = 0.0, y = 0.0, z = 0.0, qx = 0.0, qy = 0.0, qz = 0.0, qw = 0.0;
  if (!(in >> seconds >> x >> y >> z >> qx >> qy >> qz >> qw) || in >> rest) {
    file.fail("must be eight numbers: timestamp tx ty tz qx qy qz qw");
  }
  const auto stamp = time_of(seconds);
  if (!stamp) file.fail("'" + seconds + "' is no timestamp in seconds");
  if (!(std::abs(qx * qx + qy * qy + qz * qz + qw * qw - 1.0) < 0.1)) {
    file.fail("the quaternion's length is not 1");
  }
  return {*stamp, {x, y, yaw_of(qx, qy, qz, qw)}};
}

}  // namespace

std::optional<Time> time_of(const std::string& seconds) {
  const auto value = number_of(seconds);
  if (!value || std::abs(*value) > kMaxSeconds) return std::nullopt;
  const bool negative = seconds[0] == '-';
  const std::string plain = seconds.substr(negative || seconds[0] == '+' ? 1 : 0);
  const std::string whole = plain.substr(0, plain.find('.'));
  std::string fraction = whole.size() < plain.size() ? plain.substr(whole.size() + 1) : "";
  if (!all_digits(whole) || !all_digits(fraction)) return Time(from_seconds(*value));
  const bool up = fraction.size() > 9 && fraction[9] >= '5';
  fraction.resize(9, '0');
  const std::int64_t count =
      std::stoll("0" + whole) * kNanoseconds + std::stoll(fraction) + (up ? 1 : 0);
  return Time(Duration(negative ? -count : count));
}

std::string tum_text(const Trajectory& trajectory) {
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const StampedPose& pose : trajectory) {
    const double half = 0.5 * rounded_heading(pose.map_T_base.theta());
    text += seconds_text(pose.stamp) + " " + fixed_text(pose.map_T_base.x(), 9) + " " +
            fixed_text(pose.map_T_base.y(), 9) + " 0 0 0 " + fixed_text(std::sin(half), 12) + " " +
            fixed_text(std::cos(half), 12) + "\n";
  }
  return text;
}

void write_tum(const std::string& path, const Trajectory& trajectory) {
  write_whole_file(path, tum_text(trajectory));
}

Trajectory read_tum(const std::string& path) {
  LineReader file(path);
  Trajectory trajectory;
  for (std::string line; file.next(line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    trajectory.push_back(parse_line(line, file));
  }
  return trajectory;
}

}  // namespace falko_slam
