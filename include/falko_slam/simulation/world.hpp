// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// How a surface sends light back. All is relative to a white matt surface that faces the beam.
struct Surface {
  std::string name;
  double reflectivity = 0.5;  ///< of a matt surface; falls with the cosine of the incidence
  double retro_gain = 0.0;    ///< of a retroreflector, the same from all sides; 0: it is none
};

/// A plane piece of surface, upright, seen from both sides [m].
struct Face {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  std::size_t surface = 0;  ///< index into World::surfaces
};

/// An upright cylinder [m]: a column, or a reflector if its surface is a retroreflector.
struct Cylinder {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.04;
  std::size_t surface = 0;
};

/// What the plane of the scanner cuts.
struct Shape {
  std::vector<Face> faces;
  std::vector<Cylinder> cylinders;
};

/// Four faces around a rectangle of `size` (along its x and y), its centre at `world_T_center`.
void add_box(Shape& shape, const Pose2& world_T_center, const Eigen::Vector2d& size,
             std::size_t surface);

/// How a thing moves: along straight lines between places, turning evenly on the way, at a constant
/// speed; where only the heading changes, at one radian per second.
struct BodyMotion {
  enum class Repeat { kOnce, kRound, kBackAndForth };
  std::vector<Pose2> through;  ///< world_T_body; one place: it stands there
  double speed = 1.0;          ///< [m/s]
  Repeat repeat = Repeat::kOnce;
};

/// Where it is at a time since the simulation began [s].
Pose2 pose_at(const BodyMotion& motion, double seconds);

/// A thing that moves, or is there for a time only.
struct Body {
  Shape shape;  ///< in its own frame
  BodyMotion motion;
  double appears = 0.0;  ///< [s]
  double disappears = std::numeric_limits<double>::infinity();
};

/// A plane world.
struct World {
  std::vector<Surface> surfaces;
  Shape fixed;  ///< in the frame of the world
  std::vector<Body> bodies;
};

}  // namespace falko_slam
