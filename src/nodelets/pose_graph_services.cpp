// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The services of the PoseGraph nodelet. They run beside its scans.
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "falko_slam/common/file_below.hpp"
#include "falko_slam/map/map_file.hpp"
#include "falko_slam/map/png_file.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/slam/slam_state_file.hpp"
#include "pose_graph_nodelet.hpp"

namespace falko_slam {
namespace {

// Without the ending that callers may add.
std::string map_name(const std::string& file) {
  constexpr char kEnding[] = ".yaml";
  constexpr std::size_t kLength = sizeof kEnding - 1;
  const bool has_ending = file.size() > kLength && file.substr(file.size() - kLength) == kEnding;
  return has_ending ? file.substr(0, file.size() - kLength) : file;
}

void make_folder_of(const std::string& path) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
}

}  // namespace

void PoseGraphNodelet::start_services() {
  ros::NodeHandle node(getPrivateNodeHandle());
  node.setCallbackQueue(&service_queue_);
  using Self = PoseGraphNodelet;
  services_ = {node.advertiseService(topics::kDynamicMap, &Self::on_dynamic_map, this),
               node.advertiseService(topics::kSaveMap, &Self::on_save_map, this),
               node.advertiseService(topics::kSaveState, &Self::on_save_state, this),
               node.advertiseService(topics::kLoadState, &Self::on_load_state, this),
               node.advertiseService(topics::kPause, &Self::on_pause, this),
               node.advertiseService(topics::kReset, &Self::on_reset, this)};
  service_thread_ = std::make_unique<ros::AsyncSpinner>(1, &service_queue_);
  service_thread_->start();
}

bool PoseGraphNodelet::on_dynamic_map(nav_msgs::GetMap::Request& /*request*/,
                                      nav_msgs::GetMap::Response& response) {
  const Drawing drawing = draw_map();
  publish(drawing);
  response.map = to_message(drawing.map, drawing.header);
  if (drawing.map.cells.empty()) NODELET_WARN("dynamic_map: there is no map yet");
  return !drawing.map.cells.empty();
}

bool PoseGraphNodelet::on_save_map(SaveMap::Request& request, SaveMap::Response& response) {
  try {
    file_below(params_.map_folder, request.file);
    const std::string name = map_name(request.file);
    const std::string yaml = file_below(params_.map_folder, name + ".yaml");
    file_below(params_.map_folder, name + ".pgm");
    const std::string png = file_below(params_.map_folder, name + ".png");
    const Drawing drawing = draw_map();
    if (drawing.map.cells.empty()) throw std::runtime_error("there is no map yet");
    publish(drawing);
    make_folder_of(yaml);
    write_map(yaml, drawing.map);
    write_png(png, trinary_image(drawing.map));
    response.success = true;
    response.message = "map of " + std::to_string(drawing.map.width) + " x " +
                       std::to_string(drawing.map.height) + " cells saved to " + yaml;
    NODELET_INFO_STREAM(response.message);
  } catch (const std::exception& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("map not saved: " << error.what());
  }
  return true;
}

bool PoseGraphNodelet::on_save_state(SaveState::Request& request, SaveState::Response& response) {
  try {
    const std::string path = file_below(params_.map_folder, request.file);
    SlamState state;
    {
      const std::lock_guard<std::mutex> lock(slam_mutex_);
      state = slam_->state();
    }
    if (state.keyframes.empty()) throw std::runtime_error("there is no keyframe to save");
    make_folder_of(path);
    save_slam_state(path, state);
    response.keyframes = state.keyframes.size();
    response.success = true;
    response.message = std::to_string(response.keyframes) + " keyframes saved to " + path;
    NODELET_INFO_STREAM(response.message);
  } catch (const std::exception& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("state not saved: " << error.what());
  }
  return true;
}

bool PoseGraphNodelet::on_load_state(LoadState::Request& request, LoadState::Response& response) {
  try {
    const std::string path = file_below(params_.map_folder, request.file);
    auto loaded = std::make_unique<FeatureSlam>(params_.slam, load_slam_state(path));
    response.keyframes = loaded->keyframes();
    replace_slam(std::move(loaded));
    response.success = true;
    response.message = std::to_string(response.keyframes) + " keyframes loaded from " + path +
                       "; waiting for a place that is recognised";
    NODELET_INFO_STREAM(response.message);
  } catch (const std::exception& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("state not loaded, the old one stays: " << error.what());
  }
  return true;
}

bool PoseGraphNodelet::on_pause(std_srvs::SetBool::Request& request,
                                std_srvs::SetBool::Response& response) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  const bool pauses = request.data != 0;
  resumed_ = resumed_ || (paused_ && !pauses);
  response.message = std::string(paused_ == pauses ? "was " : "") +
                     (pauses ? "paused: scans are not used" : "running");
  paused_ = pauses;
  transform_->hold(pauses);
  diagnostics_->paused(pauses);
  response.success = true;
  NODELET_INFO_STREAM(response.message);
  return true;
}

bool PoseGraphNodelet::on_reset(std_srvs::Trigger::Request& /*request*/,
                                std_srvs::Trigger::Response& response) {
  const std::size_t keyframes = replace_slam(std::make_unique<FeatureSlam>(params_.slam));
  response.success = true;
  response.message = std::to_string(keyframes) + " keyframes forgotten";
  NODELET_INFO_STREAM(response.message);
  return true;
}

std::size_t PoseGraphNodelet::replace_slam(std::unique_ptr<FeatureSlam> slam) {
  queue_->clear();
  const std::lock_guard<std::mutex> slam_lock(slam_mutex_);
  slam_.swap(slam);
  shared_scans_.clear();
  share_new_scans();
  closure_news_.reset();
  view_changes_ = map_changes_ = {true, true, true};
  {
    const std::lock_guard<std::mutex> state_lock(state_mutex_);
    transform_->reset();
    diagnostics_->restarted(slam_->keyframes());
  }
  {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    wake_ = true;
  }
  stopping_.notify_all();
  return slam->keyframes();
}

}  // namespace falko_slam
