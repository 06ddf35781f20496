// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/evaluation/simulated_calibration.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double between(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Of base_link, seen from the start.
Points way_points(const CalibrationPlan& plan, const TricycleParams& tricycle) {
  constexpr int kPieces = 32;
  Points points;
  Pose2 here;
  for (const PlannedArc& arc : arcs_of(plan)) {
    const double length = plan.turn * tricycle.wheelbase / std::abs(std::sin(arc.steering));
    const double ticks = std::copysign(length / tricycle.driving_scale, arc.wheel_speed);
    for (int i = 0; i < kPieces; ++i) {
      here = here * drive_arc(tricycle, ticks / kPieces, arc.steering);
      points.push_back(here.translation());
    }
  }
  return points;
}

double least_distance(const Points& points, const Eigen::Vector2d& from) {
  double least = (points.front() - from).norm();
  for (const Eigen::Vector2d& point : points) least = std::min(least, (point - from).norm());
  return least;
}

Eigen::Vector2d middle_of(const Points& points) {
  Eigen::Vector2d low = points.front(), high = low;
  for (const Eigen::Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return 0.5 * (low + high);
}

}  // namespace

void validate(const RandomHallParams& params) {
  require_in_range("hall.max_reflectors", params.max_reflectors, 3, 1000);
  require_in_range("hall.min_reflectors", params.min_reflectors, 3, params.max_reflectors);
  require_in_range("hall.max_distance", params.max_distance, 1.0, 100.0);
  require_in_range("hall.min_distance", params.min_distance, 1.0, params.max_distance);
  require_in_range("hall.clearance", params.clearance, 0.0, 10.0);
  require_in_range("hall.max_wall_gap", params.max_wall_gap, 0.1, 100.0);
  require_in_range("hall.min_wall_gap", params.min_wall_gap, 0.1, params.max_wall_gap);
  require_in_range("hall.reflector_radius", params.reflector_radius, 0.005, 0.5);
}

Scenario random_hall(const RandomHallParams& params, const CalibrationPlan& plan,
                     const TricycleParams& tricycle, std::mt19937_64& random) {
  validate(params);
  validate(plan);
  Scenario scenario;
  scenario.name = "random_hall";
  scenario.world.surfaces = {{"wall", 0.5, 0.0}, {"reflector", 0.3, 500.0}};
  scenario.world_T_start = Pose2(0.0, 0.0, between(-kPi, kPi, random));
  Points way = way_points(plan, tricycle);
  for (Eigen::Vector2d& point : way) point = scenario.world_T_start * point;
  const Eigen::Vector2d middle = middle_of(way);
  const auto half_side = [&] {
    return params.max_distance + between(params.min_wall_gap, params.max_wall_gap, random);
  };
  const double half_length = half_side(), half_width = half_side();
  add_box(scenario.world.fixed, {middle.x(), middle.y(), 0.0},
          {2.0 * half_length, 2.0 * half_width}, 0);
  const int count =
      std::uniform_int_distribution<int>(params.min_reflectors, params.max_reflectors)(random);
  auto& reflectors = scenario.world.fixed.cylinders;
  for (int tries = 0; static_cast<int>(reflectors.size()) < count; ++tries) {
    if (tries > 1000 * count) {
      throw std::invalid_argument("hall.clearance: no room for reflectors beside the way");
    }
    const double far = between(params.min_distance, params.max_distance, random);
    const double angle = between(-kPi, kPi, random);
    const Eigen::Vector2d place = middle + far * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    if (least_distance(way, place) < params.clearance) continue;
    reflectors.push_back({place, params.reflector_radius, 1});
  }
  return scenario;
}

}  // namespace falko_slam
