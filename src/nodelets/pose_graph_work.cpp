// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thread of the PoseGraph nodelet that works through the scans.
#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "pose_graph_nodelet.hpp"
#include "steady_now.hpp"

namespace falko_slam {
void PoseGraphNodelet::work() {
  while (const auto input = queue_->pop()) {
    try {
      take(**input);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("scan at " << to_ros((*input)->scan.stamp) << ": " << error.what());
      const std::lock_guard<std::mutex> lock(state_mutex_);
      diagnostics_->failed(error.what());
    }
  }
}

void PoseGraphNodelet::take(const Input& input) {
  const std::lock_guard<std::mutex> slam_lock(slam_mutex_);
  if (input.drive != slam_drive_) {
    slam_drive_ = input.drive;
    slam_->begin_drive();
  }
  const double begin = steady_now();
  const SlamStep step = slam_->add(input.scan);
  const double duration = steady_now() - begin;
  for (Changes* changes : {&view_changes_, &map_changes_}) {
    changes->graph |= step.is_keyframe;
    changes->poses |= step.optimized;
  }
  share_new_scans();
  publish_step(input, step);
  const std::lock_guard<std::mutex> state_lock(state_mutex_);
  diagnostics_->processed(step, duration);
  if (input.drive != drive_) return;  // what it says is of the drive before
  if (!step.anchored) return transform_->reset();
  const Pose2 odom_T_base = input.scan.odom_T_base.value_or(Pose2());
  transform_->set(step.map_T_base * odom_T_base.inverse(), odom_T_base, ros::Time::now());
}

void PoseGraphNodelet::share_new_scans() {
  while (shared_scans_.size() < slam_->keyframes()) {
    shared_scans_.push_back(
        std::make_shared<LaserScan>(slam_->record({shared_scans_.size()}).scan));
  }
}

void PoseGraphNodelet::publish_step(const Input& input, const SlamStep& step) {
  if (step.is_keyframe && step.keyframe) publish_closures(input.scan, *step.keyframe);
  if (!step.anchored) return;
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = params_.map_frame;
  message.header.stamp = to_ros(input.scan.stamp);
  message.pose = to_message(PoseEstimate{step.map_T_base, step.covariance});
  pose_.publish(message);
}

void PoseGraphNodelet::publish_closures(const SlamScan& scan, KeyframeId source) {
  LoopConstraintArray message;
  message.header.frame_id = params_.map_frame;
  message.header.stamp = to_ros(scan.stamp);
  message.source = source.value;
  for (const std::size_t number : closure_news_.changed(slam_->closures())) {
    message.constraints.push_back(to_message(slam_->closures()[number], *slam_));
  }
  constraints_.publish(message);
}

}  // namespace falko_slam
