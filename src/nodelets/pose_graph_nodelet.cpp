// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the PoseGraph nodelet starts and ends.
#include "pose_graph_nodelet.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/MapMetaData.h>
#include <visualization_msgs/MarkerArray.h>

#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/slam/slam_state_file.hpp"
#include "node_constants.hpp"

namespace falko_slam {
namespace {

constexpr double kSecond = 1.0;

}  // namespace

PoseGraphNodelet::~PoseGraphNodelet() {
  // Nothing may come in while members go.
  if (service_thread_) service_thread_->stop();
  for (ros::ServiceServer& service : services_) service.shutdown();
  transform_timer_.stop();
  second_timer_.stop();
  transforms_.shutdown();
  input_.reset();
  if (queue_) queue_->close();
  {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    stop_ = true;
  }
  stopping_.notify_all();
  if (worker_.joinable()) worker_.join();
  if (drawer_.joinable()) drawer_.join();
}

void PoseGraphNodelet::onInit() {
  // All that may throw comes first: what is connected then would outlive its queue.
  load_parameters();
  load_first_state();
  start_publishing();
  start_threads();
  start_listening();
  start_timers();
  start_services();
}

void PoseGraphNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_slam_node_params(parameter_tree(node), node.getNamespace(), unknown);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
  if (!params_.use_odometry) {
    NODELET_WARN_STREAM("without odometry: scans are registered alone, and tf "
                        << params_.map_frame << " -> " << params_.base_frame << " is sent");
  }
}

void PoseGraphNodelet::load_first_state() {
  try {
    SlamState state;
    if (!params_.state.empty()) state = load_slam_state(params_.state);
    slam_ = std::make_unique<FeatureSlam>(params_.slam, state);
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM("parameter state: " << error.what());
    throw;
  }
  share_new_scans();
  growing_map_ = GrowingMap(params_.slam.map);
  queue_ = std::make_unique<InputQueue>(static_cast<std::size_t>(params_.queue_size));
  MapTransformParams transform;
  transform.map_frame = params_.map_frame;
  transform.child_frame = params_.use_odometry ? params_.odom_frame : params_.base_frame;
  transform.tolerance = params_.transform_tolerance;
  transform.timeout = params_.scan_timeout;
  if (params_.use_odometry) transform.slew = params_.slew;
  transform_ = std::make_unique<MapTransform>(transform);
  diagnostics_ = std::make_unique<SlamDiagnostics>(
      TopicWatch(heard_topic<sensor_msgs::LaserScan>(getNodeHandle().resolveName(topics::kScan)),
                 ros::SteadyTime::now().toSec()),
      params_.use_odometry, params_.scan_timeout);
  if (slam_->keyframes() == 0) return;
  diagnostics_->restarted(slam_->keyframes());
  view_changes_ = map_changes_ = {true, true, true};
  NODELET_INFO_STREAM(slam_->keyframes() << " keyframes from " << params_.state);
}

void PoseGraphNodelet::start_publishing() {
  ros::NodeHandle& node = getNodeHandle();
  pose_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>(topics::kPose, kQueue);
  map_ = node.advertise<nav_msgs::OccupancyGrid>(topics::kMap, 1, true);
  map_metadata_ = node.advertise<nav_msgs::MapMetaData>(topics::kMapMetadata, 1, true);
  path_ = node.advertise<nav_msgs::Path>(topics::kPath, 1, true);
  markers_ = node.advertise<visualization_msgs::MarkerArray>(topics::kGraphMarkers, 1, true);
  constraints_ = node.advertise<LoopConstraintArray>(topics::kConstraints, kQueue);
  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>();
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
  updater_->setHardwareID("none");
  updater_->add("slam", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    diagnostics_->report(status, {ros::SteadyTime::now().toSec(), ros::Time::now().toSec()});
  });
}

void PoseGraphNodelet::start_threads() {
  worker_ = std::thread([this] { work(); });
  drawer_ = std::thread([this] { draw_views(); });
}

void PoseGraphNodelet::start_listening() {
  ScanInputParams params;
  params.odom_frame = params_.odom_frame;
  params.base_frame = params_.base_frame;
  params.use_odometry = params_.use_odometry;
  params.scan = params_.slam.scan;
  ScanInput::Listener listener;
  listener.received = [this](const ScanReport& report) { on_received(report); };
  listener.dropped = [this](const std::string& missing) { on_dropped(missing); };
  listener.placed = [this](SlamScan scan) { on_placed(std::move(scan)); };
  listener.time_has_jumped = [this](double seconds) { on_time_jump(seconds); };
  input_ = std::make_unique<ScanInput>(getNodeHandle(), params, listener);
  if (!params_.publish_tf) return;
  // The frame must have one broadcaster; tf2 does not tell who it is.
  constexpr std::uint32_t kTransformQueue = 100;
  transforms_ = getNodeHandle().subscribe<tf2_msgs::TFMessage>(
      "/tf", kTransformQueue,
      boost::function<void(const TransformEvent&)>(
          [this](const TransformEvent& event) { on_transforms(event); }));
}

void PoseGraphNodelet::start_timers() {
  ros::NodeHandle& node = getNodeHandle();
  if (params_.publish_tf) {
    transform_timer_ = node.createTimer(ros::Duration(params_.transform_period),
                                        [this](const ros::TimerEvent&) { on_transform_timer(); });
  }
  // On the wall clock: silence must be told of even when simulated time stands still.
  second_timer_ = node.createWallTimer(ros::WallDuration(kSecond),
                                       [this](const ros::WallTimerEvent&) { on_second_timer(); });
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::PoseGraphNodelet, nodelet::Nodelet)
