// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/place_recognition/scan_view.hpp"

namespace falko_slam {

/// Where a point stands to the surface that a scan saw in its direction.
struct Footing {
  const SurfacePoint* surface = nullptr;
  double distance = std::numeric_limits<double>::infinity();  ///< to the surface [m]
  double range = 0.0;  ///< the farthest of the beams looked at [m]; 0: none is valid
};

/// Distance to a piece of wall: across it, and along it beyond its half length. [m]
inline double distance_to(const SurfacePoint& surface, const Eigen::Vector2d& point) {
  const Eigen::Vector2d difference = point - surface.position;
  const Eigen::Vector2d& n = surface.normal;
  if (n.x() == 0.0 && n.y() == 0.0) return difference.norm();
  const double across = n.dot(difference);
  const double along = difference.x() * n.y() - difference.y() * n.x();
  const double beyond = std::max(0.0, std::abs(along) - surface.length);
  return beyond > 0.0 ? std::sqrt(across * across + beyond * beyond) : std::abs(across);
}

/// The surface at the beam that looks towards the point (scan's frame), if it is `near` [m]; else
/// the nearest one of that beam and the two beside it. The nearest of all three in any case would
/// be the one whose noise fits best, and make residuals look smaller than they are.
inline Footing footing(const ScanView& view, const Eigen::Vector2d& point, double near) {
  Footing result;
  const auto towards = view.beam_at(approximate_atan2(point.y(), point.x()));
  if (!towards) return result;
  const auto look_at = [&](std::size_t beam) {
    result.range = std::max(result.range, view.range(beam));
    const SurfacePoint& surface = view.surface(beam);
    if (surface.length <= 0.0) return;
    const double distance = distance_to(surface, point);
    if (distance < result.distance) result.distance = distance, result.surface = &surface;
  };
  look_at(*towards);
  if (result.distance < near) return result;
  const std::size_t last = view.beam_count() - 1;
  if (*towards > 0 || view.closed()) look_at(*towards > 0 ? *towards - 1 : last);
  if (*towards < last || view.closed()) look_at(*towards < last ? *towards + 1 : 0);
  return result;
}

}  // namespace falko_slam
