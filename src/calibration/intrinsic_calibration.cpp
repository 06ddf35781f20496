// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/intrinsic_calibration.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace falko_slam {
namespace {

// Greatest quotient of the eigenvalues of M that still means something in double precision.
constexpr double kWorstCondition = 1e12;

// One direction's block of M and P, (2.20), (2.21).
struct NormalEquations {
  Eigen::Matrix2d M = Eigen::Matrix2d::Zero();
  Eigen::Vector2d P = Eigen::Vector2d::Zero();

  void add(const PathSegment& segment) {
    const Eigen::Vector2d row(segment.ticks * std::sin(segment.steering),
                              segment.ticks * std::cos(segment.steering));
    M += row * row.transpose();
    P += row * segment.turn;
  }
};

// A block in the axes of its eigenvectors, turned so that all of c is negative, (2.23).
struct DiagonalBlock {
  Eigen::Matrix2d psi_of_xi;  // V S_c
  Eigen::Vector2d d, c;
  bool regular = false;

  explicit DiagonalBlock(const NormalEquations& equations) {
    const Eigen::Matrix2d& M = equations.M;
    const double angle = 0.5 * std::atan2(-2.0 * M(0, 1), M(1, 1) - M(0, 0));
    Eigen::Matrix2d V;
    V << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Eigen::Vector2d VP = V.transpose() * equations.P;
    const Eigen::Vector2d signs(VP.x() >= 0.0 ? 1.0 : -1.0, VP.y() >= 0.0 ? 1.0 : -1.0);
    psi_of_xi = V * signs.asDiagonal();
    d = (psi_of_xi.transpose() * M * psi_of_xi).diagonal();
    c = -VP.cwiseAbs();
    regular =
        d.minCoeff() > 0.0 && d.maxCoeff() < kWorstCondition * d.minCoeff() && VP.norm() > 0.0;
  }

  // (2.24) with w the sign of the block in the constraint.
  Eigen::Vector2d xi(double w_lambda) const {
    return {-c.x() / (d.x() + w_lambda), -c.y() / (d.y() + w_lambda)};
  }
  Eigen::Vector2d psi(double w_lambda) const { return psi_of_xi * xi(w_lambda); }
};

// g decreases on (A, B), so halving finds its root to the last bit.
double multiplier(const DiagonalBlock& forward, const DiagonalBlock& backward) {
  double low = -forward.d.minCoeff();   // A, (2.25)
  double high = backward.d.minCoeff();  // B
  for (int i = 0; i < 2000; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    const double g = forward.xi(middle).squaredNorm() - backward.xi(-middle).squaredNorm();
    (g > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double offset_of(const Eigen::Vector2d& psi) { return std::atan2(psi.y(), psi.x()); }

}  // namespace

std::optional<TricycleParams> calibrate_standard(const std::vector<PathSegment>& segments,
                                                 double wheelbase) {
  NormalEquations equations;
  for (const PathSegment& segment : segments) equations.add(segment);
  const DiagonalBlock block(equations);
  if (!block.regular) return std::nullopt;
  const Eigen::Vector2d psi = block.psi(0.0);  // (2.13)
  return TricycleParams{wheelbase, wheelbase * psi.norm(), offset_of(psi), offset_of(psi)};
}

std::optional<TricycleParams> calibrate_asymmetric(const std::vector<PathSegment>& segments,
                                                   double wheelbase) {
  NormalEquations forward_equations, backward_equations;
  for (const PathSegment& segment : segments) {
    (segment.ticks > 0.0 ? forward_equations : backward_equations).add(segment);
  }
  const DiagonalBlock forward(forward_equations), backward(backward_equations);
  if (!forward.regular || !backward.regular) return std::nullopt;
  const double lambda = multiplier(forward, backward);
  const Eigen::Vector2d psi_F = forward.psi(lambda), psi_B = backward.psi(-lambda);
  const double driving_scale = 0.5 * wheelbase * (psi_F.norm() + psi_B.norm());         // (2.27)
  return TricycleParams{wheelbase, driving_scale, offset_of(psi_F), offset_of(psi_B)};  // (2.26)
}

}  // namespace falko_slam
