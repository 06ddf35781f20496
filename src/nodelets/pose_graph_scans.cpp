// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the PoseGraph nodelet does in its queue: scans come in, tf goes out, nothing waits.
#include <cmath>
#include <utility>

#include "node_constants.hpp"
#include "pose_graph_nodelet.hpp"
#include "steady_now.hpp"

namespace falko_slam {
namespace {

constexpr double kConflictShown = 10.0;  // [s]

}  // namespace

void PoseGraphNodelet::on_received(const ScanReport& report) {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    diagnostics_->received(report, {steady_now(), ros::Time::now().toSec()});
  }
  if (!report.usable()) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "unusable scan: " << describe(report));
  } else if (report.count(BeamStatus::kValid) == 0 || report.angles_disagree() ||
             report.surplus_beams > 1) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "strange scan: " << describe(report));
  }
}

void PoseGraphNodelet::on_dropped(const std::string& missing) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  diagnostics_->dropped(missing);
  NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped, " << missing << "; "
                                                                << diagnostics_->dropped_scans()
                                                                << " so far");
}

bool PoseGraphNodelet::has_moved(const SlamScan& scan) const {
  if (!scan.odom_T_base || !last_odom_T_base_) return true;
  const Pose2 way = last_odom_T_base_->inverse() * *scan.odom_T_base;
  return way.translation().norm() > params_.slam.tracker.min_step ||
         std::abs(way.theta()) > params_.slam.tracker.min_turn;
}

void PoseGraphNodelet::begin_drive(const std::string& reason) {
  ++drive_;
  transform_->reset();
  last_odom_T_base_.reset();
  NODELET_WARN_STREAM(reason << ": a new drive begins, which has to find its place in the map");
}

void PoseGraphNodelet::on_placed(SlamScan scan) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  if (paused_) return diagnostics_->ignored();
  if (std::exchange(resumed_, false) && has_moved(scan)) begin_drive("moved while paused");
  last_odom_T_base_ = scan.odom_T_base;
  if (queue_->push(std::make_shared<Input>(Input{std::move(scan), drive_}))) return;
  diagnostics_->overflowed();
  NODELET_WARN_STREAM_THROTTLE(kWarningPeriod,
                               "scans are dropped: they come faster than they are done");
}

void PoseGraphNodelet::on_time_jump(double seconds) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  transform_->rewind();
  begin_drive("time has jumped back by " + std::to_string(seconds) + " s");
}

void PoseGraphNodelet::on_transform_timer() {
  std::optional<geometry_msgs::TransformStamped> transform;
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    transform = transform_->at(ros::Time::now());
  }
  if (transform) broadcaster_->sendTransform(*transform);
}

void PoseGraphNodelet::on_transforms(const TransformEvent& event) {
  const std::string& sender = event.getPublisherName();
  if (sender == ros::this_node::getName()) return;  // of another nodelet beside us we cannot know
  const std::lock_guard<std::mutex> lock(state_mutex_);
  for (const geometry_msgs::TransformStamped& transform : event.getMessage()->transforms) {
    if (tf_frame(transform.child_frame_id) != transform_->child_frame()) continue;
    conflict_ = steady_now();
    diagnostics_->warn("tf -> " + transform_->child_frame() + ": " + sender + " sends it, too");
  }
}

void PoseGraphNodelet::on_second_timer() {
  input_->watch_time();
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    if (steady_now() - conflict_ > kConflictShown) diagnostics_->warn("");
  }
  updater_->force_update();
}

}  // namespace falko_slam
