// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_agreement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/common/validation.hpp"

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
  const double along = difference.x() * surface.normal.y() - difference.y() * surface.normal.x();
  const double beyond = std::max(0.0, std::abs(along) - surface.length);
  return std::sqrt(across * across + beyond * beyond);
}

Footing footing(const ScanView& view, const Eigen::Vector2d& point) {
  Footing result;
  const auto nearest = view.beam_at(std::atan2(point.y(), point.x()));
  if (!nearest) return result;
  const auto look_at = [&](std::size_t beam) {
    result.range = std::max(result.range, view.range(beam));
    const SurfacePoint& surface = view.surface(beam);
    if (surface.length <= 0.0) return;
    const double distance = distance_to(surface, point);
    if (distance < result.distance) result.distance = distance, result.surface = &surface;
  };
  const std::size_t last = view.beam_count() - 1;
  look_at(*nearest);
  if (*nearest > 0 || view.closed()) look_at(*nearest > 0 ? *nearest - 1 : last);
  if (*nearest < last || view.closed()) look_at(*nearest < last ? *nearest + 1 : 0);
  return result;
}

}  // namespace

void validate(const AgreementParams& params) {
  require_in_range("tolerance", params.tolerance, 1e-3, 10.0);
  require_in_range("see_through", params.see_through, 0.0, 100.0);
}

void validate(const RegistrationParams& params) {
  require_in_range("iterations", params.iterations, 1, 1000);
  require_in_range("first_gate", params.first_gate, 1e-3, 100.0);
  require_in_range("last_gate", params.last_gate, 1e-3, 100.0);
}

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

namespace {

// The normal equations of the point-to-line distances, about the position of the source:
//     r = n . (target_T_source p - q),  dr/d(x, y, theta) = (n_x, n_y, n . perp(R p)).
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double squares = 0.0;
  std::size_t pairs = 0;

  void add(const SurfacePoint& surface, const Eigen::Vector2d& point, const Pose2& pose) {
    const Eigen::Vector2d arm = point - pose.translation();
    const Eigen::Vector2d& n = surface.normal;
    const double residual = n.dot(point - surface.position);
    const Eigen::Vector3d jacobian(n.x(), n.y(), n.y() * arm.x() - n.x() * arm.y());
    information += jacobian * jacobian.transpose();
    gradient += jacobian * residual;
    squares += residual * residual;
    ++pairs;
  }
};

NormalEquations equations(const ScanView& target, const ScanView& source, const Pose2& pose,
                          double gate) {
  NormalEquations result;
  for (const SurfacePoint& point : source.points()) {
    const Eigen::Vector2d in_target = pose * point.position;
    const Footing found = footing(target, in_target);
    if (found.surface == nullptr || found.distance > gate) continue;
    if (found.surface->normal.isZero(0.0)) continue;
    result.add(*found.surface, in_target, pose);
  }
  return result;
}

// 1 if the normals point in all directions alike, 0 if they are parallel.
double constraint_of(const Eigen::Matrix2d& scatter) {
  const double half_trace = 0.5 * scatter.trace();
  const double half_difference = 0.5 * (scatter(0, 0) - scatter(1, 1));
  return (half_trace - std::hypot(half_difference, scatter(0, 1))) / half_trace;
}

}  // namespace

std::optional<Registration> register_scans(const ScanView& target, const ScanView& source,
                                           const Pose2& initial, const RegistrationParams& params) {
  constexpr std::size_t kLeastPairs = 10;
  constexpr double kSmallStep = 1e-3;  // [m], [rad]
  Registration result;
  Pose2 pose = initial;
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    const bool fine = 2 * iteration >= params.iterations;
    const NormalEquations sum =
        equations(target, source, pose, fine ? params.last_gate : params.first_gate);
    if (sum.pairs < kLeastPairs) return std::nullopt;
    const Eigen::LDLT<Eigen::Matrix3d> solver(sum.information);
    const Eigen::Vector3d pivots = solver.vectorD();
    if (!(pivots.minCoeff() > 1e-6 * pivots.maxCoeff())) return std::nullopt;
    const Eigen::Vector3d step = solver.solve(-sum.gradient);
    pose = Pose2(pose.translation() + step.head<2>(), pose.theta() + step.z());
    const auto pairs = static_cast<double>(sum.pairs);
    result.rms_residual = std::sqrt(sum.squares / pairs);
    result.constraint = constraint_of(sum.information.topLeftCorner<2, 2>());
    result.target_T_source.covariance =
        sum.squares / (pairs - 3.0) * solver.solve(Eigen::Matrix3d::Identity());
    if (fine && step.cwiseAbs().maxCoeff() < kSmallStep) break;
  }
  result.target_T_source.pose = pose;
  return result;
}

}  // namespace falko_slam
