// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "incremental_solver.hpp"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cmath>

#include "block_ordering.hpp"

namespace falko_slam {
namespace {

constexpr int kMaxSteps = 20;
constexpr int kMaxGradients = 12;  // beyond, a new factorisation is cheaper
// The squared distance to the optimum in standard deviations, g^T H^-1 g, of which no node is
// further off than that: enough, and how much less than before a step must leave.
constexpr double kNearEnough = 1e-5;
constexpr double kRoughly = 1.0;
constexpr double kStepLeaves = 1e-3;
constexpr double kStepLeavesAtMost = 1e-3;  // more, and what is left bends soft stretches
constexpr double kLeastPart = 0.1;          // of a step that must pay

Eigen::Matrix3d frame_of(const Eigen::Vector3d& pose) {
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  frame.topLeftCorner<2, 2>() << std::cos(pose.z()), -std::sin(pose.z()), std::sin(pose.z()),
      std::cos(pose.z());
  return frame;
}

auto block(Eigen::VectorXd& x, std::size_t node) {
  return x.segment<3>(3 * static_cast<Eigen::Index>(node));
}
auto block(const Eigen::VectorXd& x, std::size_t node) {
  return x.segment<3>(3 * static_cast<Eigen::Index>(node));
}

// Whitens for the loss and returns it. The row's J^T r becomes rho' J^T r and its J^T J becomes
// J^T (rho' + 2 rho'' r r^T) J (\cite triggs2000, Eq. (11)), kept positive.
template <class Row>
double soften(Row& row, const OptimizerParams& params) {
  constexpr double kLeast = 0.25;
  const double squared = row.residual.squaredNorm();
  const LossValue loss = evaluate_loss(params.closure_loss, params.loss_scale, squared);
  const double along =
      std::sqrt(std::max(kLeast, 1.0 + 2.0 * loss.curvature * squared / loss.slope));
  Eigen::Matrix3d whitening = Eigen::Matrix3d::Identity();
  if (along < 1.0) whitening -= (1.0 - along) / squared * row.residual * row.residual.transpose();
  whitening *= std::sqrt(loss.slope);
  row.dfrom = whitening * row.dfrom;
  row.dto = whitening * row.dto;
  row.residual *= std::sqrt(loss.slope) / along;
  return loss.cost;
}

}  // namespace

// Returns the cost.
double IncrementalSolver::linearize(const GraphProblem& problem, const OptimizerParams& params) {
  std::vector<Eigen::Matrix3d> frames;
  frames.reserve(problem.poses.size());
  for (const Eigen::Vector3d& pose : problem.poses) frames.push_back(frame_of(pose));
  rows_.clear();
  rows_.reserve(problem.factors.size());
  double cost = 0.0;
  for (const GraphFactor& f : problem.factors) {
    if (!f.in_force) continue;
    const auto linear = f.factor.linearize(problem.poses[f.from], problem.poses[f.to]);
    Row row{f.from, f.to, linear.dfrom * frames[f.from], linear.dto * frames[f.to],
            linear.residual};
    cost += f.robust ? soften(row, params) : row.residual.squaredNorm();
    rows_.push_back(row);
  }
  return cost;
}

Eigen::VectorXd IncrementalSolver::gradient() const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(anchored_.size()));
  for (const Row& row : rows_) {
    block(sum, row.from).noalias() += row.dfrom.transpose() * row.residual;
    block(sum, row.to).noalias() += row.dto.transpose() * row.residual;
  }
  for (std::size_t i = 0; i < anchored_.size(); ++i) {
    if (anchored_[i]) block(sum, i).setZero();
  }
  return sum;
}

// x is zero at the nodes that are anchored, and so is the product.
Eigen::VectorXd IncrementalSolver::times_hessian(const Eigen::VectorXd& x) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(x.size());
  for (const Row& row : rows_) {
    const Eigen::Vector3d image = row.dfrom * block(x, row.from) + row.dto * block(x, row.to);
    block(sum, row.from).noalias() += row.dfrom.transpose() * image;
    block(sum, row.to).noalias() += row.dto.transpose() * image;
  }
  for (std::size_t i = 0; i < anchored_.size(); ++i) {
    if (anchored_[i]) block(sum, i).setZero();
  }
  return sum;
}

bool IncrementalSolver::factorize() {
  BlockPattern pattern(anchored_);
  for (const Row& row : rows_) pattern.add(row.from, row.to);
  column_ = pattern.order();
  BlockMatrix hessian(3 * pattern.size());
  for (const Row& row : rows_) {
    const Eigen::Index from = column_[row.from], to = column_[row.to];
    hessian.add(from, from, row.dfrom.transpose() * row.dfrom);
    hessian.add(to, to, row.dto.transpose() * row.dto);
    if (from > to) hessian.add(from, to, row.dfrom.transpose() * row.dto);
    if (to > from) hessian.add(to, from, row.dto.transpose() * row.dfrom);
  }
  base_anchored_ = anchored_;
  base_.compute(hessian.lower_triangle());
  if (base_.info() != Eigen::Success) base_anchored_.clear();
  return base_.info() == Eigen::Success;
}

// Each node that is not factorised to an older one; false if that cannot be.
bool IncrementalSolver::hang_new_nodes() {
  const std::size_t base = base_anchored_.size();
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> row_of(anchored_.size() - base, kNone);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t node = std::max(rows_[i].from, rows_[i].to);
    if (node >= base && row_of[node - base] == kNone) row_of[node - base] = i;
  }
  branches_.clear();
  for (std::size_t node = base; node < anchored_.size(); ++node) {
    if (anchored_[node] || row_of[node - base] == kNone) return false;
    const Row& row = rows_[row_of[node - base]];
    const bool forward = row.to == node;
    const Eigen::Matrix3d inverse = (forward ? row.dto : row.dfrom).inverse();
    if (!inverse.allFinite()) return false;
    branches_.push_back({row_of[node - base], node, forward ? row.from : row.to, inverse,
                         forward ? row.dfrom : row.dto});
  }
  return true;
}

// Factorises if the last factorisation cannot be used any more.
bool IncrementalSolver::prepare() {
  const bool usable = !base_anchored_.empty() && base_anchored_.size() <= anchored_.size() &&
                      std::equal(base_anchored_.begin(), base_anchored_.end(), anchored_.begin()) &&
                      hang_new_nodes();
  if (usable) return true;
  branches_.clear();
  return factorize();
}

// Branches are eliminated from the tips: a node that hangs by one factor leaves nothing of it on
// its parent's side of the matrix, only of the right side.
Eigen::VectorXd IncrementalSolver::precondition(const Eigen::VectorXd& b) const {
  Eigen::VectorXd x = b;
  for (auto branch = branches_.rbegin(); branch != branches_.rend(); ++branch) {
    const Eigen::Vector3d pull = branch->dnode_inverse.transpose() * block(x, branch->node);
    block(x, branch->node) = pull;
    block(x, branch->parent) -= branch->dparent.transpose() * pull;
  }
  Eigen::VectorXd right(base_.rows());
  for (std::size_t i = 0; i < base_anchored_.size(); ++i) {
    if (column_[i] >= 0) right.segment<3>(column_[i]) = block(x, i);
  }
  const Eigen::VectorXd solved = base_.solve(right);
  for (std::size_t i = 0; i < base_anchored_.size(); ++i) {
    if (column_[i] >= 0) {
      block(x, i) = solved.segment<3>(column_[i]);
    } else {
      block(x, i).setZero();
    }
  }
  for (const Branch& branch : branches_) {
    block(x, branch.node) =
        branch.dnode_inverse * (block(x, branch.node) - branch.dparent * block(x, branch.parent));
  }
  return x;
}

bool IncrementalSolver::conjugate_gradients(const Eigen::VectorXd& right, Eigen::VectorXd& x) {
  x.setZero(right.size());
  Eigen::VectorXd left = right;
  Eigen::VectorXd direction = precondition(left);
  double distance = left.dot(direction);
  const double enough = std::clamp(kStepLeaves * distance, 0.01 * kNearEnough, kStepLeavesAtMost);
  for (int i = 0; i < kMaxGradients; ++i) {
    if (!(distance > enough)) return std::isfinite(distance);
    const Eigen::VectorXd image = times_hessian(direction);
    const double along = distance / direction.dot(image);
    x += along * direction;
    left -= along * image;
    const Eigen::VectorXd better = precondition(left);
    const double next = left.dot(better);
    direction = better + next / distance * direction;
    distance = next;
  }
  return false;
}

bool IncrementalSolver::step(const Eigen::VectorXd& right, Eigen::VectorXd& x) {
  if (!prepare()) return false;
  if (conjugate_gradients(right, x)) return true;
  branches_.clear();
  return factorize() && conjugate_gradients(right, x);
}

bool IncrementalSolver::solve(GraphProblem& problem, const OptimizerParams& params,
                              OptimizationSummary& summary, bool roughly) {
  const std::vector<Eigen::Vector3d> start = problem.poses;
  anchored_ = problem.anchored();
  double cost = linearize(problem, params);
  Eigen::VectorXd x;
  for (summary.iterations = 0; summary.iterations < kMaxSteps; ++summary.iterations) {
    const Eigen::VectorXd right = -gradient();
    if (!step(right, x)) break;
    const double distance = right.dot(x);
    const double last = cost;
    const std::vector<Eigen::Vector3d> before = problem.poses;
    double part = 1.0;
    for (; part >= kLeastPart; part *= 0.5) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        problem.poses[i] = before[i] + part * (frame_of(before[i]) * block(x, i));
      }
      cost = linearize(problem, params);
      if (cost <= last + 1e-9 * (1.0 + last)) break;
    }
    if (part < kLeastPart) break;
    if (distance > (roughly ? kRoughly : kNearEnough)) continue;
    ++summary.iterations;
    summary.converged = true;
    summary.message = "the steps have become small";
    return true;
  }
  problem.poses = start;
  return false;
}

}  // namespace falko_slam
