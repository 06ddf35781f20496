// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "path_tracking.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "path_follower.hpp"

namespace falko_slam {
namespace {

constexpr double kSearch = 1.0;        // ahead of where it was [m]
constexpr double kTangent = 0.02;      // over which a direction is taken [m]
constexpr double kWindow = 0.3;        // over which a curvature is taken, at least [m]
constexpr double kSteeringTime = 1.2;  // from straight on to a narrow curve [s]
constexpr double kView = 3.0;          // how far ahead curves are looked for [m]
constexpr double kLastMetre = 1.0;
constexpr double kStraight = 1e-3;  // [rad]

std::vector<Eigen::Vector2d> points_of(const FollowStep& step, const Eigen::Vector2d& begin) {
  std::vector<Eigen::Vector2d> points{begin};
  for (const Eigen::Vector2d& point : step.through) {
    if ((point - points.back()).norm() > 1e-3) points.push_back(point);
  }
  return points;
}

}  // namespace

PathTracking::PathTracking(const FollowStep& step, const LayoutFollowerParams& params,
                           const Eigen::Vector2d& begin)
    : step_(step),
      params_(params),
      path_(RoundedPath(points_of(step, begin), step.corner_radius)
                .smoothed(kSteeringTime * step.speed)) {}

// Of the path itself, in the direction in which it is gone.
double PathTracking::heading_at(double way) const {
  const double to = std::clamp(way + 0.5 * kTangent, kTangent, std::max(kTangent, path_.length()));
  const Eigen::Vector2d along = path_.at(to) - path_.at(to - kTangent);
  return std::atan2(along.y(), along.x());
}

// Positive: the path bends to the left.
double PathTracking::path_curvature(double way) const {
  const double from = std::max(0.0, way - 0.5 * kWindow);
  const double to = std::min(path_.length(), way + 0.5 * kWindow);
  if (to - from < kTangent) return 0.0;
  return angle_between(heading_at(from), heading_at(to)) / (to - from);
}

void PathTracking::move_to(const Pose2& map_T_base) {
  const Eigen::Vector2d& here = map_T_base.translation();
  const double from = std::min(way_, path_.length());
  const double nearest = path_.nearest(here, from, from + kSearch);
  const double heading = heading_at(nearest);
  const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d offset = here - path_.at(nearest);
  way_ = nearest + along.dot(offset);
  cross_track_ = along.x() * offset.y() - along.y() * offset.x();
  const double wanted = step_.backward ? heading + kPi : heading;
  heading_error_ = angle_between(wanted, map_T_base.theta());
}

double PathTracking::curvature(double speed) const {
  const double response = params_.response + params_.response_time * speed;
  const double direction = step_.backward ? -1.0 : 1.0;
  // Seen by the vehicle, what lies left of a path that it backs along lies to its right.
  const double left = direction * cross_track_;
  const double distance = std::clamp(left / response, -0.7, 0.7);
  return direction * (path_curvature(way_) - 2.0 * heading_error_ / response) - distance / response;
}

double PathTracking::speed_limit() const {
  const double begin = std::clamp(way_, 0.0, path_.length());
  const double view = std::min(kView, path_.length() - begin);
  double limit = std::min(step_.speed, braking_speed(remaining(), params_.acceleration));
  for (double ahead = 0.0; ahead <= view; ahead += 0.1) {
    const double curvature = std::abs(path_curvature(begin + ahead));
    const double there = std::sqrt(params_.max_sideways / std::max(1e-3, curvature));
    limit = std::min(limit, std::hypot(there, braking_speed(ahead, params_.acceleration)));
  }
  return limit;
}

Pose2 PathTracking::map_T_end() const {
  const double heading = heading_at(path_.length());
  const Eigen::Vector2d end = path_.at(path_.length());
  return {end.x(), end.y(), wrap_angle(step_.backward ? heading + kPi : heading)};
}

bool PathTracking::ends_in_curve() const {
  const double before = heading_at(std::max(0.0, path_.length() - kLastMetre));
  return std::abs(angle_between(before, heading_at(path_.length()))) > kStraight;
}

}  // namespace falko_slam
