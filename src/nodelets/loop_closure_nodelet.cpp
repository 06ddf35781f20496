// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_closure_nodelet.hpp"

#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/loop_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"
#include "steady_now.hpp"

namespace falko_slam {
namespace {

constexpr std::uint32_t kWaitingScans = 20;
constexpr double kTimerPeriod = 1.0;  // of diagnostics and markers [s]

}  // namespace

LoopClosureNodelet::~LoopClosureNodelet() {
  // Nothing may come in while members go.
  if (service_thread_) service_thread_->stop();
  for (ros::ServiceServer* service : {&locate_, &save_, &load_}) service->shutdown();
  timer_.stop();
  scans_.unsubscribe();
  filter_.reset();
}

void LoopClosureNodelet::onInit() {
  // All that may throw comes first: what is connected then would outlive its queue.
  load_parameters();
  load_database();
  loop_markers_ = std::make_unique<LoopMarkers>(params_.odom_frame);
  diagnostics_ = std::make_unique<LoopDiagnostics>(
      TopicWatch(heard_topic<sensor_msgs::LaserScan>(getNodeHandle().resolveName(topics::kScan)),
                 steady_now()));
  start_publishing();
  if (!memory_->records().empty()) announce_reset();
  start_listening();
  start_services();
}

void LoopClosureNodelet::load_parameters() {
  std::vector<std::string> unknown;
  try {
    params_ = read_loop_closure_parameters(getPrivateNodeHandle(), unknown);
    selector_ = KeyframeSelector(params_.closure.selector);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
}

void LoopClosureNodelet::load_database() {
  std::vector<KeyframeRecord> records;
  try {
    if (!params_.database.empty()) records = read_keyframe_file(params_.database);
  } catch (const std::runtime_error& error) {
    NODELET_FATAL_STREAM("parameter database: " << error.what());
    throw;
  }
  memory_ = std::make_unique<KeyframeMemory>(params_.closure, records);
  if (!records.empty()) {
    NODELET_INFO_STREAM(records.size() << " keyframes from " << params_.database);
  }
}

void LoopClosureNodelet::start_publishing() {
  ros::NodeHandle& node = getNodeHandle();
  keyframes_ = node.advertise<KeyframeArray>(topics::kKeyframes, kQueue, true);
  constraints_ = node.advertise<LoopConstraintArray>(topics::kConstraints, kQueue);
  markers_ = node.advertise<visualization_msgs::MarkerArray>(topics::kLoopMarkers, 1, true);
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
  updater_->setHardwareID("none");
  updater_->add("loop closure", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    diagnostics_->report(status, steady_now());
  });
}

void LoopClosureNodelet::start_listening() {
  ros::NodeHandle& node = getNodeHandle();
  filter_ = std::make_unique<ScanFilter>(
      node, params_.odom_frame, params_.base_frame, kWaitingScans,
      ScanFilter::Listener{
          [this](const auto& message) { on_scan(message); },
          [this](const auto& /*message*/, const std::string& missing) { on_dropped(missing); }});
  scans_.registerCallback(
      boost::function<void(const sensor_msgs::LaserScanConstPtr&)>([this](const auto& message) {
        on_received(message);
        filter_->add(message);
      }));
  scans_.subscribe(node, topics::kScan, kWaitingScans);
  // On the wall clock: silence must be told of even when simulated time stands still.
  timer_ = node.createWallTimer(ros::WallDuration(kTimerPeriod),
                                [this](const ros::WallTimerEvent&) { on_timer(); });
}

void LoopClosureNodelet::on_timer() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    watch_time();
    const std::uint32_t subscribers = markers_.getNumSubscribers();
    if (subscribers > 0 && (markers_changed_ || subscribers != marker_subscribers_)) {
      markers_.publish(loop_markers_->markers(ros::Time::now()));
      markers_changed_ = false;
    }
    marker_subscribers_ = subscribers;
  }
  updater_->force_update();
}

void LoopClosureNodelet::watch_time() {
  const double back = filter_->watch_time();
  if (back <= 0.0) return;
  begin_drive("time has jumped back by " + std::to_string(back) + " s");
  selector_.reset();
}

void LoopClosureNodelet::begin_drive(const std::string& reason) {
  NODELET_WARN_STREAM(
      reason << ": a new drive begins, its odometry is not connected to that before");
  memory_->begin_drive();
}

ScanReport LoopClosureNodelet::normalized(const sensor_msgs::LaserScan& message,
                                          const LaserPlace& place, LaserScan& scan) const {
  ScanNormalizerParams params = params_.closure.scan;
  params.upside_down = place.upside_down.value_or(params.upside_down);
  return normalize(as_raw_scan(message), params, scan);
}

void LoopClosureNodelet::on_received(const sensor_msgs::LaserScanConstPtr& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  LaserScan scan;
  const ScanReport report = normalized(*message, {}, scan);
  diagnostics_->received(report, steady_now());
  if (!report.usable()) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "unusable scan: " << describe(report));
    return;
  }
  if (report.count(BeamStatus::kValid) == 0 || report.angles_disagree() ||
      report.surplus_beams > 1) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "strange scan: " << describe(report));
  }
  last_scan_ = message;
}

void LoopClosureNodelet::on_dropped(const std::string& missing) {
  const std::lock_guard<std::mutex> lock(mutex_);
  diagnostics_->dropped(missing);
  NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped, " << missing << "; "
                                                                << diagnostics_->dropped_scans()
                                                                << " so far");
}

void LoopClosureNodelet::on_scan(const sensor_msgs::LaserScanConstPtr& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  watch_time();
  KeyframeRecord record;
  LaserPlace place;
  try {
    place = filter_->poses().mount(message->header.frame_id);
    record.odom_T_laser = filter_->poses().at(message->header.frame_id, message->header.stamp);
  } catch (const tf2::TransformException& error) {
    diagnostics_->dropped(error.what());
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped: " << error.what());
    return;
  }
  if (normalized(*message, place, record.scan).count(BeamStatus::kValid) == 0) return;
  record.stamp = from_ros(message->header.stamp);
  record.base_T_laser = place.base_T_laser;
  const KeyframeSelector::Choice choice = selector_.choose(record.odom_T_laser);
  if (choice == KeyframeSelector::Choice::kPassOver) return;
  if (choice == KeyframeSelector::Choice::kFirstOfNew) begin_drive("the odometry has jumped");
  add_keyframe(std::move(record));
}

void LoopClosureNodelet::add_keyframe(KeyframeRecord record) {
  const double begin = steady_now();
  const KeyframeId id = memory_->add(std::move(record));
  const LoopDetection detection = memory_->detect(id);
  diagnostics_->added(id, detection, steady_now() - begin);

  keyframes_.publish(
      boost::make_shared<KeyframeArray>(to_message(*memory_, id, params_.odom_frame)));
  constraints_.publish(boost::make_shared<LoopConstraintArray>(
      to_message(*memory_, id, detection, params_.odom_frame)));
  loop_markers_->add(memory_->record(id));
  loop_markers_->add(*memory_, id, detection);
  markers_changed_ = true;
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::LoopClosureNodelet, nodelet::Nodelet)
