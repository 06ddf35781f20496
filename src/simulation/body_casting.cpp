// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "ray_fan.hpp"

namespace falko_slam {
namespace {

// How far a shape reaches from its own origin [m].
double radius_of(const Shape& shape) {
  double radius = 0.0;
  for (const Face& face : shape.faces) {
    radius = std::max({radius, face.from.norm(), face.to.norm()});
  }
  for (const Cylinder& cylinder : shape.cylinders) {
    radius = std::max(radius, cylinder.center.norm() + cylinder.radius);
  }
  return radius;
}

// The beams that can meet what is within `radius` of a place.
std::vector<std::size_t> beams_towards(const RayFan& fan, const Eigen::Vector2d& place,
                                       double radius) {
  const Eigen::Vector2d to = place - fan.center;
  const double width = radius + fan.reach;
  const bool around = to.norm() <= width;
  const double half = around ? kPi : std::asin(width / to.norm()) + fan.bearing_margin;
  const double middle = std::atan2(to.y(), to.x());
  std::vector<std::size_t> beams;
  for (std::size_t beam = 0; beam < fan.beams(); ++beam) {
    if (std::abs(angle_between(middle, fan.bearing[beam])) <= half) beams.push_back(beam);
  }
  return beams;
}

// One beam, as the thing at `world_T_body` sees it; each of its rays is tried on each of its faces.
RayFan seen_from_body(const RayFan& fan, std::size_t beam, const Pose2& world_T_body) {
  const Pose2 body_T_world = world_T_body.inverse();
  const Eigen::Matrix2d rotation = body_T_world.rotation();
  RayFan seen;
  seen.rays_per_beam = fan.rays_per_beam;
  seen.reach = std::numeric_limits<double>::infinity();
  seen.resize(1);
  for (std::size_t k = 0; k < fan.rays_per_beam; ++k) {
    const std::size_t ray = beam * fan.rays_per_beam + k;
    const Eigen::Vector2d begin = body_T_world * Eigen::Vector2d(fan.x[ray], fan.y[ray]);
    const Eigen::Vector2d direction = rotation * Eigen::Vector2d(fan.dx[ray], fan.dy[ray]);
    seen.x[k] = begin.x();
    seen.y[k] = begin.y();
    seen.dx[k] = direction.x();
    seen.dy[k] = direction.y();
    seen.range[k] = fan.range[ray];
    seen.light[k] = fan.light[ray];
  }
  return seen;
}

}  // namespace

void cast(const Body& body, const std::vector<Surface>& surfaces,
          const std::vector<double>& seconds, RayFan& fan) {
  if (fan.beams() == 0) return;
  const double duration = seconds.back() - seconds.front();
  const Pose2 middle = pose_at(body.motion, 0.5 * (seconds.front() + seconds.back()));
  const double radius = radius_of(body.shape) + 0.5 * duration * body.motion.speed + 1e-3;
  for (const std::size_t beam : beams_towards(fan, middle.translation(), radius)) {
    if (seconds[beam] < body.appears || seconds[beam] >= body.disappears) continue;
    RayFan seen = seen_from_body(fan, beam, pose_at(body.motion, seconds[beam]));
    cast(body.shape, surfaces, seen);
    for (std::size_t k = 0; k < fan.rays_per_beam; ++k) {
      fan.range[beam * fan.rays_per_beam + k] = seen.range[k];
      fan.light[beam * fan.rays_per_beam + k] = seen.light[k];
    }
  }
}

}  // namespace falko_slam
