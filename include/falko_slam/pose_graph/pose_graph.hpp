// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/common/keyframe_id.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

struct GraphNode {
  KeyframeId id;
  Pose2 map_T_node;
};

enum class ConstraintKind {
  kOdometry,      ///< of one node and the next, from the wheels
  kRegistration,  ///< of one node and a near one, from their scans
  kClosure,       ///< of two nodes that are far apart in time: may be false
};

/// A measured pose of one node seen from another.
///
/// The residual is the one of g2o (\cite kummerle2011g2o), what is left between measured and
/// estimated pose, seen from the measured one:
///
///     e = (R_z^T (R_i^T (t_j - t_i) - t_z), wrap(theta_j - theta_i - theta_z))
///       = coordinates of from_T_to^-1 * map_T_from^-1 * map_T_to        [m, m, rad]
///
/// with i = `from`, j = `to`, z = `from_T_to`. `information` is the inverse of the covariance of e:
/// x and y lie along the axes of the frame `to`, not of `from` as in a PoseEstimate.
struct GraphConstraint {
  KeyframeId from{}, to{};
  Pose2 from_T_to{};
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  ConstraintKind kind = ConstraintKind::kOdometry;
};

/// Nodes and what was measured between them. Where none is fixed, the first node of each connected
/// part is.
struct PoseGraph {
  std::vector<GraphNode> nodes;
  std::vector<GraphConstraint> constraints;
  std::vector<KeyframeId> fixed;
};

/// A constraint from an estimate, whose covariance lies along the axes of `from`. Throws
/// std::invalid_argument unless the covariance is finite, symmetric and positive definite.
GraphConstraint constraint_between(KeyframeId from, KeyframeId to, const PoseEstimate& from_T_to,
                                   ConstraintKind kind);

/// The measurement as an estimate, its covariance along the axes of `from`. Throws
/// std::invalid_argument unless the information is positive definite.
PoseEstimate estimate_of(const GraphConstraint& constraint);

/// e of the constraint, as above.
Eigen::Vector3d residual_of(const GraphConstraint& constraint, const Pose2& map_T_from,
                            const Pose2& map_T_to);

/// e^T information e: the squared Mahalanobis distance of estimate and measurement.
double chi2_of(const GraphConstraint& constraint, const Pose2& map_T_from, const Pose2& map_T_to);

/// Sum over all constraints. Throws std::invalid_argument if one names a node that is not there.
double chi2_of(const PoseGraph& graph);

/// A with A^T A = information, symmetric positive semidefinite. Throws std::invalid_argument, with
/// the matrix, for one that is not finite, not symmetric, or has a negative eigenvalue.
Eigen::Matrix3d square_root_of_information(const Eigen::Matrix3d& information);

}  // namespace falko_slam
