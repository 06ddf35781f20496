// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// A covariance of exp(tangent) * pose, tangent in the frame of the chain's first node.
inline Eigen::Matrix3d moved(const Pose2& pose, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d adjoint = pose.adjoint();
  return adjoint * covariance * adjoint.transpose();
}

/// Nodes one behind the other with what odometry says of them; any stretch of it in O(1), for the
/// errors of the steps, brought to the frame of the first node, add up.
class OdometryChain {
 public:
  /// A stretch that is run through from one end to the other, which may lie behind.
  struct Stretch {
    std::size_t from, to;
    std::size_t first() const { return std::min(from, to); }
    std::size_t last() const { return std::max(from, to); }
    double sign() const { return from <= to ? 1.0 : -1.0; }
  };

  void add(const PoseEstimate& last_T_node) {
    if (poses_.empty()) {
      poses_.emplace_back();
      sums_.emplace_back(Eigen::Matrix3d::Zero());
      return;
    }
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = last_T_node.pose.rotation().transpose();
    poses_.push_back(poses_.back() * last_T_node.pose);
    low_ = low_.cwiseMin(poses_.back().translation());
    high_ = high_.cwiseMax(poses_.back().translation());
    const Eigen::Matrix3d sum =
        sums_.back() + moved(poses_.back(), turn * last_T_node.covariance * turn.transpose());
    sums_.push_back(sum);
  }
  const Pose2& pose(std::size_t node) const { return poses_[node]; }
  std::size_t size() const { return poses_.size(); }

  /// Of the box that holds the nodes, as seen along the first one, its sides 10 m at least. [m^2]
  double area() const { return (high_ - low_).cwiseMax(10.0).prod(); }

  Eigen::Matrix3d covariance(const Stretch& stretch) const {
    return between(stretch.first(), stretch.last());
  }
  /// Of going `there` and, with the map moved by `shift`, `back`.
  Eigen::Matrix3d covariance(const Stretch& there, const Stretch& back, const Pose2& shift) const {
    const std::size_t first = std::max(there.first(), back.first());
    const std::size_t last = std::max(first, std::min(there.last(), back.last()));
    const Eigen::Matrix3d shared = between(first, last);
    const Eigen::Matrix3d both =
        there.sign() * Eigen::Matrix3d::Identity() + back.sign() * shift.adjoint();
    return covariance(there) - shared + moved(shift, covariance(back) - shared) +
           both * shared * both.transpose();
  }

 private:
  Eigen::Matrix3d between(std::size_t first, std::size_t last) const {
    return sums_[last] - sums_[first];
  }

  std::vector<Pose2> poses_;           // first_T_node
  std::vector<Eigen::Matrix3d> sums_;  // of the errors of the steps so far
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero(), high_ = Eigen::Vector2d::Zero();
};

}  // namespace falko_slam
