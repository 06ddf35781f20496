// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "support/slam_drives.hpp"

namespace falko_slam {
namespace test {

/// Four corridors around a square block, with doors in recesses on both sides.
struct CorridorRing {
  double length = 60.0;       ///< of each, from corner to corner of their middle lines [m]
  double width = 2.4;         ///< [m]
  double door_every = 4.0;    ///< on average [m]
  double irregularity = 0.6;  ///< of the spacing, as a share of it; 0: all doors alike
  int side_rooms = 6;         ///< behind outer doors that stand open
};

namespace corridor_ring {

struct Doors {
  std::vector<double> at;  // from the wall's begin [m]
  double width = 0.95;     // [m]
  double depth = 0.25;     // [m]
};

// A wall along x from 0, recesses on the side of positive y, one of them open if asked for.
inline void add_wall(Scene& scene, const Pose2& begin, double length, double away,
                     const Doors& doors, double open_door) {
  Eigen::Vector2d last(0.0, 0.0);
  const auto to = [&](double x, double y, bool wall = true) {
    const Eigen::Vector2d next(x, away * y);
    if (wall) scene.walls.push_back({begin * last, begin * next});
    last = next;
  };
  for (const double door : doors.at) {
    to(door, 0.0);
    to(door, doors.depth);
    to(door + doors.width, doors.depth, door != open_door);
    to(door + doors.width, 0.0);
  }
  to(length, 0.0);
}

inline Doors doors_along(double length, const CorridorRing& ring, std::mt19937_64& random) {
  Doors doors;
  const double spread = ring.irregularity * ring.door_every;
  double at = 0.5 * ring.door_every + (spread > 0.0 ? uniform(random, 0.0, spread) : 0.0);
  while (at + doors.width + 0.5 < length) {
    doors.at.push_back(at);
    at += ring.door_every + (spread > 0.0 ? uniform(random, -spread, spread) : 0.0);
  }
  return doors;
}

// 4 m by 5 m behind an open door at `door`, with something in it.
inline void add_room(Scene& scene, const Pose2& wall, double door, std::mt19937_64& random) {
  const double left = door - uniform(random, 0.5, 2.5), depth = 0.25;
  const auto at = [&](double x, double y) { return wall * Eigen::Vector2d(x, -y); };
  const double right = left + 4.0, end = depth + 5.0;
  scene.walls.push_back({at(left, depth), at(door, depth)});
  scene.walls.push_back({at(door + 0.95, depth), at(right, depth)});
  scene.walls.push_back({at(left, depth), at(left, end)});
  scene.walls.push_back({at(right, depth), at(right, end)});
  scene.walls.push_back({at(left, end), at(right, end)});
  scene.add_box(wall * Pose2(left + uniform(random, 0.8, 3.2), -uniform(random, 2.0, 4.2), 0.3),
                {uniform(random, 0.4, 1.2), uniform(random, 0.4, 0.8)});
}

}  // namespace corridor_ring

/// About the origin, the middle lines half a length from it.
inline Scene scene_of(const CorridorRing& ring, std::mt19937_64& random) {
  Scene scene;
  const double half = 0.5 * ring.length, beside = 0.5 * ring.width;
  int rooms = ring.side_rooms;
  for (int side = 0; side < 4; ++side) {
    const Pose2 turn(0.0, 0.0, 0.5 * kPi * side);
    const double outer = ring.length + ring.width, inner = ring.length - ring.width;
    const auto outer_doors = corridor_ring::doors_along(outer, ring, random);
    const auto inner_doors = corridor_ring::doors_along(inner, ring, random);
    const Pose2 outer_wall = turn * Pose2(-half - beside, -half - beside, 0.0);
    const Pose2 inner_wall = turn * Pose2(-half + beside, -half + beside, 0.0);
    double open = -1.0;
    if (rooms > 0) {
      --rooms;
      open = outer_doors.at[static_cast<std::size_t>(
          uniform(random, 2.0, static_cast<double>(outer_doors.at.size()) - 3.0))];
      corridor_ring::add_room(scene, outer_wall, open, random);
    }
    corridor_ring::add_wall(scene, outer_wall, outer, -1.0, outer_doors, open);
    corridor_ring::add_wall(scene, inner_wall, inner, 1.0, inner_doors, -1.0);
  }
  return scene;
}

/// Rounds along the middle, corners with a radius of 1 m, and 10 m more.
inline Poses path_of(const CorridorRing& ring, double rounds, double step) {
  constexpr double kRadius = 1.0;
  const double half = 0.5 * ring.length;
  const double straight = ring.length - 2.0 * kRadius;
  const double quarter = straight + 0.5 * kPi * kRadius;
  Poses path;
  for (double way = 0.0; way < 4.0 * rounds * quarter + 10.0; way += step) {
    const double side = std::floor(way / quarter);
    const double rest = way - side * quarter;
    const double turn = rest > straight ? (rest - straight) / kRadius : 0.0;
    const Pose2 along(std::min(rest, straight) - half + kRadius, -half, 0.0);
    const Pose2 arc(kRadius * std::sin(turn), kRadius * (1.0 - std::cos(turn)), turn);
    path.push_back(Pose2(0.0, 0.0, 0.5 * kPi * side) * along * arc);
  }
  return path;
}

/// What a laser of 181 beams to the front that sees 30 m takes in; noise of 1 cm.
inline SlamDrive drive_around(const Scene& scene, const Poses& path, std::mt19937_64& random) {
  SimulatedLaserParams laser;
  laser.beams = 181;
  laser.angle_min = -0.5 * kPi;
  laser.angle_increment = kPi / 180.0;
  laser.range_max = 30.0;
  SlamDrive drive;
  for (const Pose2& pose : path) {
    const Pose2 mount(0.2, 0.0, 0.0);
    const auto ranges = simulate_ranges(scene, pose * mount, laser, random);
    RawScan raw;
    raw.angle_min = laser.angle_min;
    raw.angle_increment = laser.angle_increment;
    raw.range_max = laser.range_max;
    raw.ranges = ranges.data();
    raw.range_count = ranges.size();
    SlamScan scan{scan_time(drive.size()), {}, pose, mount};
    normalize(raw, {}, scan.scan);
    drive.push_back({std::move(scan), pose});
  }
  return drive;
}

}  // namespace test
}  // namespace falko_slam
