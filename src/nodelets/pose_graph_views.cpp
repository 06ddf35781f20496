// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thread of the PoseGraph nodelet that draws path, markers and map.
#include <nav_msgs/MapMetaData.h>
#include <visualization_msgs/MarkerArray.h>

#include "falko_slam/ros_bridge/graph_markers.hpp"
#include "pose_graph_nodelet.hpp"
#include "steady_now.hpp"

namespace falko_slam {
namespace {

constexpr std::chrono::seconds kPeriod{1};
// The map is drawn during one of so many parts of the time, at most.
constexpr double kShare = 5.0;

}  // namespace

std_msgs::Header PoseGraphNodelet::map_header() const {
  std_msgs::Header header;
  header.frame_id = params_.map_frame;
  header.stamp = ros::Time::now();
  return header;
}

void PoseGraphNodelet::draw_views() {
  std::unique_lock<std::mutex> lock(stop_mutex_);
  while (!stop_) {
    lock.unlock();
    try {
      publish_views();
      if (map_is_due()) publish(draw_map());
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(10.0, "the map cannot be drawn: " << error.what());
    }
    lock.lock();
    stopping_.wait_for(lock, kPeriod, [this] { return stop_ || wake_; });
    wake_ = false;
  }
}

void PoseGraphNodelet::publish_views() {
  const std::lock_guard<std::mutex> lock(slam_mutex_);
  const std::uint32_t subscribers = markers_.getNumSubscribers();
  const bool more_subscribers = subscribers > marker_subscribers_;
  marker_subscribers_ = subscribers;
  const Changes changes = std::exchange(view_changes_, {});
  const std_msgs::Header header = map_header();
  if (changes.everything) markers_.publish(no_markers(header));
  const bool changed = changes.graph || changes.poses || changes.everything;
  if (subscribers > 0 && (changed || more_subscribers)) {
    markers_.publish(graph_markers(*slam_, header));
  }
  if (!changed) return;
  path_.publish(path_of(*slam_, header));
  const std::lock_guard<std::mutex> state_lock(state_mutex_);
  diagnostics_->tally(slam_->keyframes(), slam_->closures());
}

bool PoseGraphNodelet::map_is_due() {
  const std::lock_guard<std::mutex> lock(slam_mutex_);
  const double since = steady_now() - drawn_;
  if (map_changes_.everything) return true;
  if (map_changes_.poses) return since > (kShare - 1.0) * drawing_time_;
  return map_changes_.graph && since > params_.map_update_period;
}

PoseGraphNodelet::Draft PoseGraphNodelet::draft() {
  const std::lock_guard<std::mutex> lock(slam_mutex_);
  map_changes_ = {};
  Draft result;
  result.header = map_header();
  for (std::size_t i = 0; i < slam_->keyframes(); ++i) {
    if (slam_->is_mapped({i})) result.scans.push_back({shared_scans_[i], slam_->map_T_laser({i})});
  }
  return result;
}

PoseGraphNodelet::Drawing PoseGraphNodelet::draw_map() {
  const std::lock_guard<std::mutex> map_lock(map_mutex_);
  const Draft of = draft();
  const double begin = steady_now();
  Drawing drawing{growing_map_.draw(of.scans), of.header};
  const double end = steady_now();
  {
    const std::lock_guard<std::mutex> lock(slam_mutex_);
    drawn_ = end;
    drawing_time_ = end - begin;
  }
  const std::lock_guard<std::mutex> lock(state_mutex_);
  diagnostics_->drawn(drawing.map.width, drawing.map.height, end - begin);
  return drawing;
}

void PoseGraphNodelet::publish(const Drawing& drawing) {
  if (drawing.map.cells.empty()) return;
  const auto message =
      boost::make_shared<nav_msgs::OccupancyGrid>(to_message(drawing.map, drawing.header));
  map_metadata_.publish(message->info);
  map_.publish(message);
}

}  // namespace falko_slam
