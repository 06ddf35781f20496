// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_values.hpp"

namespace falko_slam {
namespace {

constexpr NumberRange kPlace{-1e4, 1e4};       // [m]
constexpr NumberRange kHeading{-1e3, 1e3};     // [rad]
constexpr NumberRange kLength{0.001, 1000.0};  // [m]
constexpr NumberRange kSpeed{0.01, 20.0};      // [m/s]

void require_list(const YamlValue& value, std::size_t least, const char* what) {
  if (!value.is_list()) value.fail(std::string("must be a list of ") + what);
  if (value.items().size() < least) {
    value.fail("must have at least " + std::to_string(least) + " " + what);
  }
}

}  // namespace

Eigen::Vector2d read_point(const YamlValue& value) {
  const auto numbers = value.numbers(2, kPlace);
  return {numbers[0], numbers[1]};
}

std::vector<Eigen::Vector2d> read_points(const YamlValue& value, std::size_t least) {
  require_list(value, least, "points [x, y]");
  std::vector<Eigen::Vector2d> points;
  for (const YamlValue& item : value.items()) {
    const Eigen::Vector2d point = read_point(item);
    if (!points.empty() && point == points.back()) item.fail("is where the point before it is");
    points.push_back(point);
  }
  return points;
}

Pose2 read_pose(const YamlValue& value) {
  const std::size_t count = value.is_list() ? value.items().size() : 0;
  if (count != 2 && count != 3) value.fail("must be [x, y, heading] or [x, y]");
  const auto items = value.items();
  return {items[0].number(kPlace), items[1].number(kPlace),
          count == 3 ? items[2].number(kHeading) : 0.0};
}

std::vector<Pose2> read_poses(const YamlValue& value) {
  require_list(value, 1, "places [x, y, heading]");
  std::vector<Pose2> poses;
  for (const YamlValue& item : value.items()) poses.push_back(read_pose(item));
  return poses;
}

Eigen::Vector2d read_size(const YamlValue& value) {
  const auto numbers = value.numbers(2, kLength);
  return {numbers[0], numbers[1]};
}

double read_radius(const YamlValue& value) { return value.number(kLength); }

double read_speed(const YamlValue& value) { return value.number(kSpeed); }

}  // namespace falko_slam
