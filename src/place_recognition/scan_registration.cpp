// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "footing.hpp"

namespace falko_slam {
namespace {

// Neighbouring residuals are alike (they share beams and normals, walls are not straight): the
// gradient is also summed over blocks of wall of this length, whose sums are independent. [m]
constexpr double kBlock = 0.5;

// The normal equations of the point-to-line distances, about the position of the source:
//     r = n . (target_T_source p - q),  dr/d(x, y, theta) = (n_x, n_y, n . perp(R p)).
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double squares = 0.0;
  std::size_t pairs = 0;
  // Squares of the gradient's parts: of the pairs, and of the blocks of neighbouring pairs.
  Eigen::Matrix3d pair_scatter = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d block_scatter = Eigen::Matrix3d::Zero();
  Eigen::Vector3d block = Eigen::Vector3d::Zero();

  void add(const SurfacePoint& surface, const Eigen::Vector2d& point, const Pose2& pose) {
    const Eigen::Vector2d arm = point - pose.translation();
    const Eigen::Vector2d& n = surface.normal;
    const double residual = n.dot(point - surface.position);
    const Eigen::Vector3d jacobian(n.x(), n.y(), n.y() * arm.x() - n.x() * arm.y());
    const Eigen::Vector3d part = jacobian * residual;
    information += jacobian * jacobian.transpose();
    gradient += part;
    squares += residual * residual;
    ++pairs;
    pair_scatter += part * part.transpose();
    block += part;
  }
  void end_block() {
    block_scatter += block * block.transpose();
    block.setZero();
  }
};

NormalEquations equations(const ScanView& target, const ScanView& source, const Pose2& pose,
                          double gate, std::size_t stride) {
  NormalEquations result;
  Eigen::Vector2d block_begin = Eigen::Vector2d::Constant(1e9);
  for (std::size_t i = 0; i < source.points().size(); i += stride) {
    const SurfacePoint& point = source.points()[i];
    const Eigen::Vector2d in_target = pose * point.position;
    const Footing found = footing(target, in_target, gate);
    if (found.surface == nullptr || found.distance > gate) continue;
    if (found.surface->normal.isZero(0.0)) continue;
    if ((point.position - block_begin).squaredNorm() > kBlock * kBlock) {
      result.end_block();
      block_begin = point.position;
    }
    result.add(*found.surface, in_target, pose);
  }
  result.end_block();
  return result;
}

// Of independent residuals of one variance, times their design effect \cite kish1965: how much
// greater the variance of the gradient is, being the sum of blocks instead of pairs.
Eigen::Matrix3d covariance_of(const NormalEquations& sum, const Eigen::Matrix3d& inverse) {
  const double variance = sum.squares / static_cast<double>(sum.pairs - 3);
  const double of_pairs = (inverse * sum.pair_scatter).trace();
  const double of_blocks = (inverse * sum.block_scatter).trace();
  const double effect = of_pairs > 0.0 ? std::max(1.0, of_blocks / of_pairs) : 1.0;
  return variance * effect * inverse;
}

// 1 if the normals point in all directions alike, 0 if they are parallel.
double constraint_of(const Eigen::Matrix2d& scatter) {
  const double half_trace = 0.5 * scatter.trace();
  const double half_difference = 0.5 * (scatter(0, 0) - scatter(1, 1));
  return (half_trace - std::hypot(half_difference, scatter(0, 1))) / half_trace;
}

}  // namespace

void validate(const RegistrationParams& params) {
  require_in_range("iterations", params.iterations, 1, 1000);
  require_in_range("first_gate", params.first_gate, 1e-3, 100.0);
  require_in_range("last_gate", params.last_gate, 1e-3, 100.0);
}

std::optional<Registration> register_scans(const ScanView& target, const ScanView& source,
                                           const Pose2& initial, const RegistrationParams& params) {
  constexpr std::size_t kLeastPairs = 10;
  constexpr std::size_t kCoarsePoints = 80;  // are enough to come near
  constexpr double kCoarseStep = 1e-2;       // [m], [rad]
  constexpr double kSmallStep = 5e-4;
  const std::size_t coarse_stride =
      std::max<std::size_t>(1, source.points().size() / kCoarsePoints);
  Registration result;
  Pose2 pose = initial;
  bool fine = false;
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    fine = fine || 2 * iteration + 1 >= params.iterations;
    const NormalEquations sum =
        fine ? equations(target, source, pose, params.last_gate, 1)
             : equations(target, source, pose, params.first_gate, coarse_stride);
    if (sum.pairs < kLeastPairs) return std::nullopt;
    const Eigen::LDLT<Eigen::Matrix3d> solver(sum.information);
    const Eigen::Vector3d pivots = solver.vectorD();
    if (!(pivots.minCoeff() > 1e-6 * pivots.maxCoeff())) return std::nullopt;
    const Eigen::Vector3d step = solver.solve(-sum.gradient);
    pose = Pose2(pose.translation() + step.head<2>(), pose.theta() + step.z());
    const double longest = step.cwiseAbs().maxCoeff();
    if (fine) {
      result.rms_residual = std::sqrt(sum.squares / static_cast<double>(sum.pairs));
      result.constraint = constraint_of(sum.information.topLeftCorner<2, 2>());
      result.target_T_source.covariance =
          covariance_of(sum, solver.solve(Eigen::Matrix3d::Identity()));
      if (longest < kSmallStep) break;
    }
    fine = fine || longest < kCoarseStep;
  }
  result.target_T_source.pose = pose;
  return result;
}

}  // namespace falko_slam
