// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/pose_graph.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "node_index.hpp"

namespace falko_slam {
namespace {

// Eigenvalues and asymmetries below this part of the largest are rounding.
constexpr double kRounding = 1e-9;

[[noreturn]] void refuse(const char* name, const Eigen::Matrix3d& matrix, const char* why) {
  static const Eigen::IOFormat kOneLine(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", "; ");
  std::ostringstream text;
  text << name << " [" << matrix.format(kOneLine) << "]: must be " << why;
  throw std::invalid_argument(text.str());
}

void require_symmetric(const char* name, const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) refuse(name, matrix, "finite");
  const double scale = matrix.cwiseAbs().maxCoeff();
  if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > kRounding * scale) {
    refuse(name, matrix, "symmetric");
  }
}

Eigen::Matrix3d inverse_of(const char* name, const Eigen::Matrix3d& matrix) {
  require_symmetric(name, matrix);
  const Eigen::LLT<Eigen::Matrix3d> factor(matrix);
  const Eigen::Matrix3d inverse = factor.solve(Eigen::Matrix3d::Identity());
  if (factor.info() != Eigen::Success || !inverse.allFinite()) {
    refuse(name, matrix, "positive definite");
  }
  return 0.5 * (inverse + inverse.transpose());
}

// Turns (x, y, theta) from the axes of `from` to those of `to`.
Eigen::Matrix3d turn_to(const Pose2& from_T_to) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = from_T_to.rotation().transpose();
  return turn;
}

}  // namespace

GraphConstraint constraint_between(KeyframeId from, KeyframeId to, const PoseEstimate& from_T_to,
                                   ConstraintKind kind) {
  const Eigen::Matrix3d turn = turn_to(from_T_to.pose);
  const Eigen::Matrix3d inverse = inverse_of("covariance", from_T_to.covariance);
  return {from, to, from_T_to.pose, turn * inverse * turn.transpose(), kind};
}

PoseEstimate estimate_of(const GraphConstraint& constraint) {
  const Eigen::Matrix3d turn = turn_to(constraint.from_T_to);
  const Eigen::Matrix3d covariance = inverse_of("information", constraint.information);
  return {constraint.from_T_to, turn.transpose() * covariance * turn};
}

Eigen::Vector3d residual_of(const GraphConstraint& constraint, const Pose2& map_T_from,
                            const Pose2& map_T_to) {
  const Pose2 left = constraint.from_T_to.inverse() * (map_T_from.inverse() * map_T_to);
  return {left.x(), left.y(), left.theta()};
}

double chi2_of(const GraphConstraint& constraint, const Pose2& map_T_from, const Pose2& map_T_to) {
  const Eigen::Vector3d residual = residual_of(constraint, map_T_from, map_T_to);
  return residual.dot(constraint.information * residual);
}

double chi2_of(const PoseGraph& graph) {
  const NodeIndex index(graph.nodes);
  double sum = 0.0;
  for (const GraphConstraint& constraint : graph.constraints) {
    sum += chi2_of(constraint, graph.nodes[index.at(constraint.from)].map_T_node,
                   graph.nodes[index.at(constraint.to)].map_T_node);
  }
  return sum;
}

Eigen::Matrix3d square_root_of_information(const Eigen::Matrix3d& information) {
  require_symmetric("information", information);
  const Eigen::LLT<Eigen::Matrix3d> cholesky(information);
  Eigen::Matrix3d upper = cholesky.matrixU();
  const double largest = information.cwiseAbs().maxCoeff();
  if (cholesky.info() == Eigen::Success &&
      upper.diagonal().minCoeff() > 1e-6 * std::sqrt(largest)) {
    return upper;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(information);
  if (eigen.eigenvalues().minCoeff() < -kRounding * largest) {
    refuse("information", information, "positive semidefinite");
  }
  return eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace falko_slam
