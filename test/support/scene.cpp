// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// An office, from its corner at the corridor, y away from it. [m], [rad]
struct Office {
  double door_x;
  double locker_x;  // in the corridor, beside the front
  double desk_x, desk_width;
  double cupboard_x, cupboard_y, cupboard_depth;
  double chair_x, chair_y, chair_angle;
};

// No two are alike: a building is not a hall of mirrors.
constexpr Office kOffices[8] = {{2.6, 1.0, 1.6, 1.6, 5.4, 4.0, 1.2, 3.6, 6.2, 0.6},
                                {1.5, 4.1, 3.9, 2.2, 0.5, 5.2, 1.8, 2.2, 4.4, 0.1},
                                {4.1, 2.9, 2.6, 1.2, 5.4, 6.3, 0.8, 4.2, 4.8, -0.5},
                                {2.2, 5.0, 4.6, 1.4, 0.5, 3.4, 1.0, 1.9, 6.0, 0.9},
                                {3.3, 1.6, 1.3, 1.0, 5.4, 2.9, 1.0, 3.0, 5.0, -0.2},
                                {4.5, 0.9, 3.1, 2.6, 0.5, 6.6, 1.2, 4.6, 3.6, 0.4},
                                {1.1, 3.4, 4.2, 1.8, 5.4, 5.6, 0.6, 1.4, 3.8, -0.8},
                                {3.7, 2.1, 2.0, 2.0, 0.5, 4.3, 1.5, 4.9, 5.7, 0.2}};

// An office of 6 m between x and x + 6 on one side (+1 or -1) of the corridor: a wall towards the
// next one, a front with a door of 0.9 m, a locker, a desk, a cupboard and two chairs.
void add_office(Scene& scene, double x, double side, const Office& office) {
  constexpr double kDoor = 0.9;
  const auto box = [&](double cx, double cy, double width, double depth, double angle) {
    scene.add_box({x + cx, side * cy, side * angle}, {width, depth});
  };
  const double door_end = office.door_x + kDoor;
  box(6.0, 5.0, 0.15, 5.8, 0.0);
  box(0.5 * office.door_x, 2.1, office.door_x, 0.15, 0.0);
  box(0.5 * (door_end + 6.0), 2.1, 6.0 - door_end, 0.15, 0.0);
  box(office.locker_x, 1.9, 0.5, 0.25, 0.0);
  box(office.desk_x, 7.0, office.desk_width, 0.8, 0.0);
  box(office.cupboard_x, office.cupboard_y, 0.6, office.cupboard_depth, 0.0);
  box(office.chair_x, office.chair_y, 0.45, 0.45, office.chair_angle);
  box(0.8 * office.desk_x + 1.1, 5.8, 0.45, 0.45, -0.3);
}

}  // namespace

void Scene::add_box(const Pose2& world_T_center, const Eigen::Vector2d& size) {
  const Eigen::Vector2d half = 0.5 * size;
  const Eigen::Vector2d corners[4] = {world_T_center * Eigen::Vector2d(-half.x(), -half.y()),
                                      world_T_center * Eigen::Vector2d(half.x(), -half.y()),
                                      world_T_center * Eigen::Vector2d(half.x(), half.y()),
                                      world_T_center * Eigen::Vector2d(-half.x(), half.y())};
  for (int i = 0; i < 4; ++i) walls.push_back({corners[i], corners[(i + 1) % 4]});
}

double Scene::cast(const Pose2& world_T_ray) const {
  const Eigen::Vector2d direction(std::cos(world_T_ray.theta()), std::sin(world_T_ray.theta()));
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d along = wall.to - wall.from;
    const double determinant = cross(direction, along);
    if (determinant == 0.0) continue;
    const Eigen::Vector2d to_wall = wall.from - world_T_ray.translation();
    const double distance = cross(to_wall, along) / determinant;
    const double share = cross(to_wall, direction) / determinant;
    if (distance > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, distance);
  }
  return nearest;
}

Scene office_scene() {
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {24.0, 16.0});
  for (int i = 0; i < 4; ++i) {
    add_office(scene, -12.0 + 6.0 * i, 1.0, kOffices[2 * i]);
    add_office(scene, -12.0 + 6.0 * i, -1.0, kOffices[2 * i + 1]);
  }
  for (int i = 0; i < 3; ++i) scene.add_box({-6.0 + 6.0 * i, 0.0, 0.0}, {0.4, 0.4});
  return scene;
}

std::vector<Pose2> office_path(double step) {
  // Around the pillars: straight along y = -1 and y = 1, half circles at the ends.
  constexpr double kHalfLength = 8.5;
  constexpr double kRadius = 1.0;
  require_in_range("step", step, 1e-4, kHalfLength);
  const double straight = 2.0 * kHalfLength;
  const double turn = kPi * kRadius;
  std::vector<Pose2> path;
  for (double way = 0.0; way < 2.0 * (straight + turn); way += step) {
    const bool back = way >= straight + turn;
    const double rest = back ? way - straight - turn : way;
    const double angle = (rest - straight) / kRadius;  // on the half circle, from its start
    const Pose2 there = rest < straight ? Pose2(rest - kHalfLength, -kRadius, 0.0)
                                        : Pose2(kHalfLength + kRadius * std::sin(angle),
                                                -kRadius * std::cos(angle), angle);
    path.push_back(back ? Pose2(0.0, 0.0, kPi) * there : there);
  }
  return path;
}

}  // namespace falko_slam
