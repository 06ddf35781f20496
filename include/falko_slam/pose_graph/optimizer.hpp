// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// rho(s) of a squared residual s, with the scale c: a false constraint pulls less than a true one.
enum class Loss {
  kNone,    ///< s
  kHuber,   ///< s up to c^2, 2 c sqrt(s) - c^2 beyond
  kCauchy,  ///< c^2 log(1 + s / c^2)
};

struct OptimizerParams {
  /// Of constraints of the kinds kClosure and kRegistration: scans may be registered wrongly, too.
  Loss closure_loss = Loss::kCauchy;
  /// In standard deviations of the residual; of true closures 95 in 100 are below 2.8. [0.01, 1000]
  double loss_scale = 2.8;
  int max_iterations = 100;  ///< [1, 10000]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const OptimizerParams& params);

struct OptimizationSummary {
  double initial_chi2 = 0.0;  ///< of the constraints in force, without loss
  double final_chi2 = 0.0;
  double final_cost =
      0.0;  ///< with loss: what was made small. Equals final_chi2 where there is none
  int iterations = 0;
  bool converged = false;
  std::string message;  ///< why it ended
};

/// The poses of the nodes for which the sum of rho(e^T information e) over all constraints is
/// least.
///
/// Keep it while the vehicle drives, and add what comes in. The fixed nodes stay where they are; of
/// a connected part without one the first node does. Move-only, not thread-safe.
class PoseGraphOptimizer {
 public:
  /// Throws std::invalid_argument.
  explicit PoseGraphOptimizer(const OptimizerParams& params = {});
  explicit PoseGraphOptimizer(const PoseGraph& graph, const OptimizerParams& params = {});
  ~PoseGraphOptimizer();
  PoseGraphOptimizer(PoseGraphOptimizer&&) noexcept;
  PoseGraphOptimizer& operator=(PoseGraphOptimizer&&) noexcept;

  /// Throws std::invalid_argument for a node that is there already or a pose that is not finite.
  void add_node(const GraphNode& node);
  /// Returns the constraint's number, counted from 0. Throws std::invalid_argument for nodes that
  /// are not there or the same, numbers that are not finite, and information that is not positive
  /// semidefinite.
  std::size_t add_constraint(const GraphConstraint& constraint);
  /// A constraint that is not in force pulls nothing.
  void set_in_force(std::size_t constraint, bool in_force);
  void fix(KeyframeId node);

  /// All nodes, from where they are, by Ceres.
  OptimizationSummary optimize();
  /// The same optimum, within a hundredth of a standard deviation, for a graph that was optimised
  /// before and has grown a little: what costs time is kept from call to call. Calls optimize()
  /// where it finds that it must.
  OptimizationSummary update();

  /// Throws std::invalid_argument for a node that is not there; so do the others.
  Pose2 pose(KeyframeId node) const;
  /// All nodes where they are now, and the constraints in force.
  PoseGraph graph() const;
  /// The covariance of the node's (x, y, theta) in the map, relative to the fixed nodes. Empty
  /// where the constraints leave the graph loose.
  std::optional<Eigen::Matrix3d> marginal_covariance(KeyframeId node) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace falko_slam
