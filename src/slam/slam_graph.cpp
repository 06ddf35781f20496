// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam_graph.hpp"

#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Between the ways of two drives [m]: whatever is asked of lengths of way, they are far apart.
constexpr double kBetweenDrives = 1000.0;

}  // namespace

SlamGraph::SlamGraph(const SlamGraphParams& params, const NearbyKeyframesParams& nearby,
                     const ConsistencyParams& consistency, const OptimizerParams& optimizer)
    : params_((validate(params), params)),
      nearby_(nearby),
      selection_(consistency),
      optimizer_(optimizer) {}

void SlamGraph::append(const Pose2& pose, double path, bool all_around) {
  const KeyframeId id{poses_.size()};
  drive_of_.push_back(drives_.size() - 1);
  nearby_.add(path, all_around);
  if (drives_.back().mapped) optimizer_.add_node({id, pose});
  poses_.push_back(pose);
}

KeyframeId SlamGraph::begin_drive(const Pose2& pose, bool all_around) {
  const KeyframeId id{poses_.size()};
  const double path = id.value > 0 ? nearby_.path({id.value - 1}) + kBetweenDrives : 0.0;
  drives_.push_back({poses_.size(), poses_.empty(), {}, {}});
  append(pose, path, all_around);
  steps_.emplace_back();
  if (is_mapped(id)) select_step(id.value);
  return id;
}

KeyframeId SlamGraph::add_step(const PoseEstimate& last_T_keyframe, bool all_around) {
  const KeyframeId last{poses_.size() - 1};
  const KeyframeId id{poses_.size()};
  const double way = last_T_keyframe.pose.translation().norm();
  append(poses_.back() * last_T_keyframe.pose, nearby_.path(last) + way, all_around);
  steps_.push_back(last_T_keyframe);
  steps_.back().covariance += pose_covariance(params_.step_distance, params_.step_turn);
  if (is_mapped(id)) select_step(id.value);
  add(constraint_between(last, id, steps_.back(), ConstraintKind::kOdometry));
  ++since_optimized_;
  return id;
}

void SlamGraph::add(const GraphConstraint& constraint) {
  nearby_.connect(constraint.from, constraint.to, estimate_of(constraint).covariance);
  Drive& drive = drive_of(constraint.to);
  if (drive.mapped) {
    put_in_force(constraint);
  } else {
    drive.waiting.push_back({constraint, std::nullopt});
  }
}

// Whether the poses are off what was measured, and farther than by chance: in a corridor the way
// along it may be far off without saying anything.
bool SlamGraph::contradicts(const GraphConstraint& constraint, double distance, double turn) const {
  constexpr double kSignificant = 16.27;  // chi2 of three degrees of freedom, 99.9 %
  const Pose2& from = poses_[constraint.from.value];
  const Pose2& to = poses_[constraint.to.value];
  const Eigen::Vector3d residual = residual_of(constraint, from, to);
  const bool far = residual.head<2>().norm() > distance || std::abs(residual.z()) > turn;
  return far && chi2_of(constraint, from, to) > kSignificant;
}

std::size_t SlamGraph::put_in_force(const GraphConstraint& constraint) {
  if (constraint.kind == ConstraintKind::kClosure) {
    changed_ = true;
    urgent_ = urgent_ || contradicts(constraint, params_.urgent_distance, params_.urgent_turn);
  }
  return optimizer_.add_constraint(constraint);
}

bool SlamGraph::optimize_if_due() {
  constexpr int kBreath = 4;  // keyframes: closures come in rows, each telling much the same
  const bool due = (urgent_ && since_optimized_ >= kBreath) ||
                   (changed_ && since_optimized_ >= params_.optimize_every);
  if (!due) return false;
  update();
  return true;
}

void SlamGraph::update() {
  optimizer_.update();
  take_poses();
}

void SlamGraph::take_poses() {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (is_mapped({i})) poses_[i] = optimizer_.pose({i});
  }
  urgent_ = changed_ = false;
  since_optimized_ = 0;
}

void SlamGraph::load(const PoseGraph& graph, const std::vector<KeyframeRecord>& keyframes) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Pose2& pose = graph.nodes[i].map_T_node;
    if (i == 0 || keyframes[i].drive != keyframes[i - 1].drive) {
      begin_drive(pose, keyframes[i].scan.closed);
      if (!drives_.back().mapped) map_drive(drives_.size() - 1, Pose2());
      continue;
    }
    const Pose2 step = poses_.back().inverse() * pose;
    append(pose, nearby_.path({i - 1}) + step.translation().norm(), keyframes[i].scan.closed);
    steps_.push_back({step, pose_covariance(params_.step_distance, params_.step_turn)});
    select_step(i);
  }
  for (const GraphConstraint& constraint : graph.constraints) add(constraint);
  for (const KeyframeId id : graph.fixed) optimizer_.fix(id);
  take_poses();
}

}  // namespace falko_slam
