// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_line.hpp"

#include <cmath>
#include <cstring>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// More beams than any scanner has: such a count is a damaged line, not a reason to allocate.
constexpr double kMaxBeams = 1e6;
// Seconds that still fit into 64 bits of nanoseconds.
constexpr double kMaxSeconds = 9e9;

// Takes numbers from a line until one is missing or not finite, and remembers that.
class CarmenNumbers {
 public:
  explicit CarmenNumbers(const char* text) : text_(text) {}

  double next() {
    const std::optional<double> value = take_number(text_);
    if (!value || !std::isfinite(*value)) {
      good_ = false;
      return 0.0;
    }
    return *value;
  }

  std::size_t next_count() {
    const double value = next();
    if (!(value >= 0.0 && value <= kMaxBeams) || value != std::floor(value)) good_ = false;
    return good_ ? static_cast<std::size_t>(value) : 0;
  }

  std::vector<float> next_ranges(std::size_t count) {
    std::vector<float> ranges;
    for (std::size_t i = 0; i < count && good_; ++i) ranges.push_back(static_cast<float>(next()));
    return ranges;
  }

  Pose2 next_pose() {
    const double x = next();
    const double y = next();
    return {x, y, next()};
  }

  Time next_time() {
    const double seconds = next();
    if (std::abs(seconds) > kMaxSeconds) good_ = false;
    return good_ ? Time(from_seconds(seconds)) : Time();
  }

  bool good() const { return good_; }

 private:
  const char* text_;
  bool good_ = true;
};

double flaser_increment(std::size_t beams) {
  if (beams == 180 || beams == 181) return degrees_to_radians(1.0);
  if (beams == 360 || beams == 361) return degrees_to_radians(0.5);
  return kPi / static_cast<double>(beams % 2 == 0 ? beams : std::max<std::size_t>(beams - 1, 1));
}

template <class Record>
std::optional<Record> if_good(const CarmenNumbers& numbers, Record&& record) {
  if (!numbers.good()) return std::nullopt;
  return std::forward<Record>(record);
}

}  // namespace

std::optional<CarmenScan> parse_flaser(const char* text, double range_max) {
  CarmenNumbers numbers(text);
  CarmenScan scan;
  const std::size_t beams = numbers.next_count();
  scan.ranges = numbers.next_ranges(beams);
  scan.world_T_laser = numbers.next_pose();
  scan.world_T_robot = numbers.next_pose();
  scan.stamp = numbers.next_time();
  scan.angle_min = -kPi / 2.0;
  scan.angle_increment = beams > 0 ? flaser_increment(beams) : 0.0;
  scan.range_max = range_max;
  return if_good(numbers, std::move(scan));
}

std::optional<CarmenScan> parse_robotlaser(const char* text) {
  CarmenNumbers numbers(text);
  CarmenScan scan;
  numbers.next();  // laser type
  scan.angle_min = numbers.next();
  const double field_of_view = numbers.next();
  scan.angle_increment = numbers.next();
  scan.range_max = numbers.next();
  numbers.next();  // accuracy
  numbers.next();  // remission mode
  const std::size_t beams = numbers.next_count();
  scan.ranges = numbers.next_ranges(beams);
  numbers.next_ranges(numbers.next_count());  // remission values
  scan.world_T_laser = numbers.next_pose();
  scan.world_T_robot = numbers.next_pose();
  for (int i = 0; i < 5; ++i) numbers.next();  // velocities, safety distances, turn axis
  scan.stamp = numbers.next_time();
  if (scan.angle_increment == 0.0 && beams > 0) {
    scan.angle_increment = field_of_view / static_cast<double>(beams);
  }
  return if_good(numbers, std::move(scan));
}

std::optional<CarmenOdometry> parse_odom(const char* text) {
  CarmenNumbers numbers(text);
  CarmenOdometry odometry;
  odometry.odom_T_robot = numbers.next_pose();
  odometry.forward_velocity = numbers.next();
  odometry.turn_velocity = numbers.next();
  numbers.next();  // acceleration
  odometry.stamp = numbers.next_time();
  return if_good(numbers, std::move(odometry));
}

std::optional<CarmenVertex> parse_vertex(const char* text) {
  CarmenNumbers numbers(text);
  CarmenVertex vertex;
  vertex.index = static_cast<long>(numbers.next_count());
  vertex.map_T_robot = numbers.next_pose();
  return if_good(numbers, std::move(vertex));
}

std::optional<double> parse_param(const char* text, const std::string& name) {
  text += std::strspn(text, " \t");
  if (std::strncmp(text, name.c_str(), name.size()) != 0) return std::nullopt;
  CarmenNumbers numbers(text + name.size());
  return if_good(numbers, numbers.next());
}

}  // namespace falko_slam
