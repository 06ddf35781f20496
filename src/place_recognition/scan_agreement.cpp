// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_agreement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace falko_slam {
namespace {

// Where a point stands to the surface that the beams beside it have seen.
struct Footing {
  const SurfacePoint* surface = nullptr;                      // the nearest piece
  double distance = std::numeric_limits<double>::infinity();  // to it [m]
  double range = 0.0;  // the farthest of the beams beside; 0: none is valid
};

// Distance to a piece of wall: across it, and along it beyond its half length.
double distance_to(const SurfacePoint& surface, const Eigen::Vector2d& point) {
  const Eigen::Vector2d difference = point - surface.position;
  if (surface.normal.isZero(0.0)) return difference.norm();
  const double across = surface.normal.dot(difference);
  const Eigen::Vector2d along = difference - across * surface.normal;
  return std::hypot(across, std::max(0.0, along.norm() - surface.length));
}

Footing footing(const ScanView& view, const Eigen::Vector2d& point) {
  Footing result;
  const ScanView::Beams beams = view.beams_at(std::atan2(point.y(), point.x()));
  if (!beams.inside) return result;
  const std::size_t count = view.beam_count();
  const auto look_at = [&](std::size_t beam) {
    result.range = std::max(result.range, view.range(beam));
    const SurfacePoint& surface = view.surface(beam);
    if (surface.length <= 0.0) return;
    const double distance = distance_to(surface, point);
    if (distance < result.distance) result.distance = distance, result.surface = &surface;
  };
  look_at(beams.nearest);
  if (beams.nearest > 0) look_at(beams.nearest - 1);
  if (beams.nearest + 1 < count) look_at(beams.nearest + 1);
  if (view.closed() && beams.nearest == 0) look_at(count - 1);
  if (view.closed() && beams.nearest + 1 == count) look_at(0);
  return result;
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& other) {
  points += other.points;
  agreeing += other.agreeing;
  missed += other.missed;
  seen_through += other.seen_through;
  length += other.length;
  agreeing_length += other.agreeing_length;
  missed_length += other.missed_length;
  seen_through_length += other.seen_through_length;
  return *this;
}

Agreement agreement(const ScanView& target, const ScanView& source, const Pose2& target_T_source,
                    const AgreementParams& params, std::size_t stride) {
  Agreement result;
  for (std::size_t i = 0; i < source.points().size(); i += stride) {
    const SurfacePoint& point = source.points()[i];
    ++result.points;
    result.length += point.length;
    const Eigen::Vector2d in_target = target_T_source * point.position;
    const Footing found = footing(target, in_target);
    if (found.range <= 0.0) continue;
    if (found.distance < params.tolerance) {
      ++result.agreeing;
      result.agreeing_length += point.length;
    } else if (in_target.norm() < found.range - params.see_through) {
      ++result.seen_through;
      result.seen_through_length += point.length;
    } else if (in_target.norm() < found.range + params.see_through) {
      ++result.missed;
      result.missed_length += point.length;
    }
  }
  return result;
}

std::optional<Registration> register_scans(const ScanView& target, const ScanView& source,
                                           const Pose2& initial, const RegistrationParams& params) {
  constexpr std::size_t kLeastPairs = 10;
  Registration result;
  Pose2 pose = initial;
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    const double gate = 2 * iteration < params.iterations ? params.first_gate : params.last_gate;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    double squares = 0.0;
    std::size_t pairs = 0;
    for (const SurfacePoint& point : source.points()) {
      const Eigen::Vector2d in_target = pose * point.position;
      const Footing found = footing(target, in_target);
      if (found.surface == nullptr || found.distance > gate) continue;
      if (found.surface->normal.isZero(0.0)) continue;
      const Eigen::Vector2d& normal = found.surface->normal;
      const double residual = normal.dot(in_target - found.surface->position);
      // About the position of the source: d residual / d (x, y, theta) in the target frame.
      const Eigen::Vector2d arm = in_target - pose.translation();
      const Eigen::Vector3d jacobian(normal.x(), normal.y(),
                                     normal.dot(Eigen::Vector2d(-arm.y(), arm.x())));
      information += jacobian * jacobian.transpose();
      gradient += jacobian * residual;
      squares += residual * residual;
      ++pairs;
    }
    if (pairs < kLeastPairs) return std::nullopt;
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    const Eigen::Vector3d pivots = solver.vectorD();
    if (!(pivots.minCoeff() > 1e-6 * pivots.maxCoeff())) return std::nullopt;
    const Eigen::Vector3d step = solver.solve(-gradient);
    pose = Pose2(pose.translation() + step.head<2>(), pose.theta() + step.z());
    const auto freedom = static_cast<double>(pairs - 3);
    const double variance = squares / freedom;
    result.rms_residual = std::sqrt(squares / static_cast<double>(pairs));
    result.target_T_source = {pose, variance * solver.solve(Eigen::Matrix3d::Identity())};
    const Eigen::Matrix2d scatter = information.topLeftCorner<2, 2>();
    const double trace = scatter.trace();
    const double root = std::sqrt(std::max(0.0, 0.25 * trace * trace - scatter(0, 0) * scatter(1, 1) + scatter(0, 1) * scatter(1, 0)));
    result.constraint = 2.0 * (0.5 * trace - root) / trace;
    if (step.head<2>().norm() < 1e-3 && std::abs(step.z()) < 1e-3 && gate == params.last_gate)
      break;
  }
  return result;
}

}  // namespace falko_slam
