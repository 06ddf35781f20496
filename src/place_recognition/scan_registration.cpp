// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_registration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "footing.hpp"
#include "registration_equations.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kLeastPairs = 10;
constexpr std::size_t kCoarsePoints = 80;  // are enough to come near
constexpr double kCoarseStep = 1e-2;       // [m], [rad]
constexpr double kSmallStep = 5e-4;
// Smallest over largest pivot from which a direction is open; a prior closes it, however weak it is
// beside what a long corridor says of the turn.
constexpr double kOpen = 1e-6;
constexpr double kOpenWithPrior = 1e-12;

struct Pairing {
  double gate;         // [m]
  double loss_scale;   // [m]
  std::size_t stride;  // of the points
};

void add_pairs(const PosedView& target, const ScanView& source, const Pose2& pose,
               const Pairing& pairing, RegistrationEquations& sum) {
  const Pose2 view_T_source = target.target_T_view.inverse() * pose;
  const Eigen::Matrix2d target_R_view = target.target_T_view.rotation();
  for (std::size_t i = 0; i < source.points().size(); i += pairing.stride) {
    const SurfacePoint& point = source.points()[i];
    const Eigen::Vector2d in_view = view_T_source * point.position;
    const Footing found = footing(*target.view, in_view, pairing.gate);
    if (found.surface == nullptr || found.distance > pairing.gate) continue;
    if (found.surface->normal.isZero(0.0)) continue;
    const double residual = found.surface->normal.dot(in_view - found.surface->position);
    sum.add({target_R_view * found.surface->normal,
             target.target_T_view * in_view - pose.translation(), point.position, residual,
             found.surface->normal_gain});
  }
  sum.end_block();
}

RegistrationEquations equations(const std::vector<PosedView>& target, const ScanView& source,
                                const Pose2& pose, const Pairing& pairing) {
  RegistrationEquations sum(pairing.loss_scale);
  for (const PosedView& view : target) add_pairs(view, source, pose, pairing, sum);
  return sum;
}

}  // namespace

void validate(const RegistrationParams& params) {
  require_in_range("iterations", params.iterations, 1, 1000);
  require_in_range("first_gate", params.first_gate, 1e-3, 100.0);
  require_in_range("last_gate", params.last_gate, 1e-3, 100.0);
  require_in_range("loss_scale", params.loss_scale, 0.0, 100.0);
}

std::optional<Registration> register_scan(const std::vector<PosedView>& target,
                                          const ScanView& source, const Pose2& initial,
                                          const RegistrationParams& params,
                                          const Eigen::Matrix3d& prior) {
  const std::size_t coarse_stride =
      std::max<std::size_t>(1, source.points().size() / kCoarsePoints);
  const bool has_prior = !prior.isZero(0.0);
  Registration result;
  Pose2 pose = initial;
  bool fine = false;
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    fine = fine || 2 * iteration + 1 >= params.iterations;
    const Pairing pairing = fine ? Pairing{params.last_gate, params.loss_scale, 1}
                                 : Pairing{params.first_gate, params.loss_scale, coarse_stride};
    const RegistrationEquations sum = equations(target, source, pose, pairing);
    if (sum.pairs() < kLeastPairs) return std::nullopt;
    // A point that has a pair in several views is still one point with one error.
    const double weight = 1.0 / static_cast<double>(target.size());
    const MeasuredPose measured = sum.measured(weight, fine && has_prior);
    const Eigen::Matrix3d information = measured.information + prior;
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    const Eigen::Vector3d pivots = solver.vectorD();
    const double open = has_prior ? kOpenWithPrior : kOpen;
    if (!(pivots.minCoeff() > open * pivots.maxCoeff())) return std::nullopt;
    const Eigen::Vector3d step =
        solver.solve(-measured.gradient - prior * difference(pose, initial));
    pose = Pose2(pose.translation() + step.head<2>(), pose.theta() + step.z());
    const double longest = step.cwiseAbs().maxCoeff();
    if (fine) {
      const Eigen::Matrix3d inverse = solver.solve(Eigen::Matrix3d::Identity());
      const double effect = sum.design_effect(inverse);
      result.rms_residual = std::sqrt(sum.mean_square());
      result.constraint = sum.constraint();
      result.information = sum.measured(weight, true).information / effect;
      result.target_T_source.covariance = (measured.information / effect + prior).inverse();
      if (longest < kSmallStep) break;
    }
    fine = fine || longest < kCoarseStep;
  }
  result.target_T_source.pose = pose;
  return result;
}

std::optional<Registration> register_scans(const ScanView& target, const ScanView& source,
                                           const Pose2& target_T_source,
                                           const RegistrationParams& params) {
  return register_scan({{&target, Pose2()}}, source, target_T_source, params);
}

}  // namespace falko_slam
