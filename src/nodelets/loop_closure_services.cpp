// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The services of the LoopClosure nodelet. They run beside its scans.
#include <filesystem>
#include <stdexcept>

#include "falko_slam/common/file_below.hpp"
#include "falko_slam/ros_bridge/loop_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "loop_closure_nodelet.hpp"

namespace falko_slam {

void LoopClosureNodelet::start_services() {
  ros::NodeHandle node(getPrivateNodeHandle());
  node.setCallbackQueue(&service_queue_);
  locate_ =
      node.advertiseService(topics::kGlobalLocalization, &LoopClosureNodelet::on_locate, this);
  save_ = node.advertiseService(topics::kSaveKeyframes, &LoopClosureNodelet::on_save, this);
  load_ = node.advertiseService(topics::kLoadKeyframes, &LoopClosureNodelet::on_load, this);
  service_thread_ = std::make_unique<ros::AsyncSpinner>(1, &service_queue_);
  service_thread_->start();
}

bool LoopClosureNodelet::on_locate(GlobalLocalization::Request& request,
                                   GlobalLocalization::Response& response) {
  constexpr std::size_t kDefaultCount = 5;
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool given = !request.scan.ranges.empty();
  if (!given && !last_scan_) {
    response.message = "no usable scan has been received, and none was given";
  } else if (memory_->records().empty()) {
    response.message = "there are no keyframes yet";
  } else {
    locate(given ? request.scan : *last_scan_,
           request.max_hypotheses > 0 ? request.max_hypotheses : kDefaultCount, response);
  }
  return true;
}

void LoopClosureNodelet::locate(const sensor_msgs::LaserScan& message, std::size_t count,
                                GlobalLocalization::Response& response) {
  response.header.stamp = message.header.stamp;
  response.header.frame_id = params_.odom_frame;
  LaserPlace place;
  try {
    place = filter_->poses().mount(message.header.frame_id);
  } catch (const tf2::TransformException& error) {
    response.message = std::string("the laser's mount is not known: ") + error.what();
    return;
  }
  LaserScan scan;
  const ScanReport report = normalized(message, place, scan);
  if (!report.usable()) {
    response.message = "unusable scan: " + describe(report);
    return;
  }
  response.hypotheses =
      to_messages(*memory_, memory_->locate(scan, count), place.base_T_laser, memory_->drive());
  response.success = static_cast<std::uint8_t>(!response.hypotheses.empty());
  response.message = response.hypotheses.empty()
                         ? "none of " + std::to_string(memory_->records().size()) +
                               " keyframes fits: " + describe(report)
                         : std::to_string(response.hypotheses.size()) + " hypotheses";
}

bool LoopClosureNodelet::on_save(SaveKeyframes::Request& request,
                                 SaveKeyframes::Response& response) {
  try {
    const std::string path = file_below(params_.folder, request.file);
    std::vector<KeyframeRecord> records;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      records = memory_->records();
    }
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    write_keyframe_file(path, records);
    response.keyframes = records.size();
    response.success = true;
    response.message = std::to_string(records.size()) + " keyframes saved to " + path;
  } catch (const std::exception& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("keyframes not saved: " << error.what());
  }
  return true;
}

bool LoopClosureNodelet::on_load(LoadKeyframes::Request& request,
                                 LoadKeyframes::Response& response) {
  try {
    const std::string path = file_below(params_.folder, request.file);
    auto loaded = std::make_unique<KeyframeMemory>(params_.closure, read_keyframe_file(path));
    const std::lock_guard<std::mutex> lock(mutex_);
    memory_.swap(loaded);
    selector_.reset();
    announce_reset();
    response.keyframes = memory_->records().size();
    response.success = true;
    response.message = std::to_string(response.keyframes) + " keyframes loaded from " + path;
    NODELET_INFO_STREAM(response.message);
  } catch (const std::exception& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("keyframes not loaded, the old ones stay: " << error.what());
  }
  return true;
}

void LoopClosureNodelet::announce_reset() {
  loop_markers_->clear();
  for (const KeyframeRecord& record : memory_->records()) loop_markers_->add(record);
  markers_changed_ = true;
  diagnostics_->loaded(memory_->records().size());
  keyframes_.publish(
      boost::make_shared<KeyframeArray>(to_message(*memory_, {0}, params_.odom_frame)));
}

}  // namespace falko_slam
