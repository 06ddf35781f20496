// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the Localizer nodelet starts and ends, and what it hears.
#include "localizer_nodelet.hpp"

#include <falko_slam/LandmarkArray.h>
#include <falko_slam/LocalizerStatus.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <iterator>
#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/localization/map_format.hpp"
#include "falko_slam/localization/pose_file.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/localizer_conversion.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"
#include "steady_now.hpp"

namespace falko_slam {
LocalizerNodelet::~LocalizerNodelet() {
  // Nothing may come in while members go.
  if (thread_) thread_->stop();
  timer_.stop();
  diagnostics_timer_.stop();
  save_timer_.stop();
  motions_.reset();
  sights_.shutdown();
  initial_poses_.shutdown();
  set_pose_.shutdown();
  global_localization_.shutdown();
  transforms_.reset();
  if (localizer_) save_pose();
}

void LocalizerNodelet::onInit() {
  // All that may throw comes first.
  load_parameters();
  load_map();
  start_publishing();
  start_listening();
  start_serving();
  thread_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  thread_->start();
}

void LocalizerNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_localizer_node_params(parameter_tree(node), node.getNamespace(), unknown);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
}

void LocalizerNodelet::load_map() {
  try {
    map_ = read_map_of_any_format(params_.map_file);
    const std::string remark = take_diameter_of(map_, params_.localizer.reflectors);
    if (!remark.empty()) NODELET_WARN_STREAM(remark);
    localizer_ = std::make_unique<Localizer>(params_.localizer, map_);
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM("parameter map_file: " << error.what());
    throw;
  }
  map_identity_ = identity_of(map_);
  NODELET_INFO_STREAM(params_.map_file << ": " << map_identity_);
  MapTransformParams transform;
  transform.map_frame = params_.map_frame;
  transform.child_frame = params_.odom_frame;
  transform.tolerance = params_.transform_tolerance;
  transform.timeout = params_.localizer.monitor.lost_silence;
  transform_ = std::make_unique<MapTransform>(transform);
}

void LocalizerNodelet::start_publishing() {
  ros::NodeHandle node(getNodeHandle()), private_node(getPrivateNodeHandle());
  node.setCallbackQueue(&queue_);
  private_node.setCallbackQueue(&queue_);
  pose_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>(topics::kPose, kQueue);
  odometry_ = node.advertise<nav_msgs::Odometry>(topics::kLocalizedOdometry, kQueue);
  landmarks_ = node.advertise<LandmarkArray>(topics::kLandmarks, kQueue);
  markers_ = node.advertise<visualization_msgs::MarkerArray>(topics::kMarkers, 1);
  status_ = node.advertise<LocalizerStatus>(topics::kStatus, 1, true);
  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>();
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, private_node, getName());
  updater_->setHardwareID("none");
  updater_->add("localization",
                [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  publish_status();
}

void LocalizerNodelet::start_listening() {
  ros::NodeHandle node(getNodeHandle());
  node.setCallbackQueue(&queue_);
  transforms_ = std::make_unique<tf2_ros::TransformListener>(buffer_, node, false);
  motions_ = std::make_unique<MotionInput>(
      node, params_,
      MotionInput::Listener{[this](const VehicleMotion& motion) { on_motion(motion); },
                            [this](double seconds) { on_time_jump(seconds); }});
  if (params_.sight_source == SightSource::kScan) {
    sights_ = node.subscribe(topics::kScan, kQueue, &LocalizerNodelet::on_scan, this);
  } else {
    sights_ = node.subscribe(topics::kReflectors, kQueue, &LocalizerNodelet::on_reflectors, this);
  }
  start_watching();
  initial_poses_ =
      node.subscribe(topics::kInitialPose, kQueue, &LocalizerNodelet::on_initial_pose, this);
}

void LocalizerNodelet::start_watching() {
  const double now = steady_now();
  const HeardTopic sights = params_.sight_source == SightSource::kScan
                                ? heard_topic<sensor_msgs::LaserScan>(sights_.getTopic())
                                : heard_topic<ReflectorArray>(sights_.getTopic());
  diagnostics_ = std::make_unique<LocalizerDiagnostics>(
      LocalizerDiagnosticsParams{params_.warn_position, params_.warn_heading},
      TopicWatch(motions_->topic(), now, params_.input_timeout),
      TopicWatch(sights, now, params_.input_timeout), now);
}

void LocalizerNodelet::start_serving() {
  ros::NodeHandle node(getNodeHandle()), private_node(getPrivateNodeHandle());
  node.setCallbackQueue(&queue_);
  private_node.setCallbackQueue(&queue_);
  set_pose_ = private_node.advertiseService(topics::kSetPose, &LocalizerNodelet::on_set_pose, this);
  global_localization_ = private_node.advertiseService(
      topics::kGlobalLocalization, &LocalizerNodelet::on_global_localization, this);
  timer_ = node.createTimer(ros::Duration(params_.transform_period),
                            [this](const ros::TimerEvent&) { on_timer(); });
  // On the wall clock: silence must be told of even when simulated time stands still.
  diagnostics_timer_ = node.createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_->force_update(); });
  save_timer_ = node.createWallTimer(ros::WallDuration(params_.pose_save_period),
                                     [this](const ros::WallTimerEvent&) { save_pose(); });
}

void LocalizerNodelet::note_stamp(Time stamp) {
  if (newest_ && stamp <= *newest_) return;
  newest_ = stamp;
  newest_received_ = ros::Time::now();
}

Time LocalizerNodelet::now() const {
  const ros::Duration since = ros::Time::now() - newest_received_;
  return *newest_ + std::max(Duration::zero(), Duration(since.toNSec()));
}

void LocalizerNodelet::on_motion(const VehicleMotion& motion) {
  note_stamp(motion.stamp);
  diagnostics_->moved(steady_now());
  diagnostics_->refused(localizer_->add_motion(motion.stamp, motion.motion));
  velocity_ = motion.velocity;
  if (!begun_) begin(motion.stamp);
  const LocalizerReport& state = localizer_->state();
  if (!state.map_T_base) return placed_.clear();
  placed_.push_back({state.stamp, state.map_T_base->pose, motion.odom_T_base});
  if (placed_.size() > kMotionsKept) placed_.pop_front();
  publish_motion();
}

void LocalizerNodelet::on_time_jump(double seconds) {
  NODELET_WARN_STREAM("time has jumped back by " << seconds << " s: the pose is kept");
  newest_.reset();
  buffer_.clear();
  transform_->rewind();
  forget_way();
}

void LocalizerNodelet::on_scan(const sensor_msgs::LaserScan& message) {
  const double began = steady_now();
  const ScanReport usable = normalize(as_raw_scan(message), params_.scan, scan_);
  if (!usable.usable()) {
    diagnostics_->unusable(steady_now(), usable);
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "unusable scan: " << describe(usable));
    return;
  }
  check_mount(message.header.frame_id);
  localizer_->add_scan(scan_);
  seen(began);
}

void LocalizerNodelet::on_reflectors(const ReflectorArray& message) {
  const double began = steady_now();
  check_mount(message.header.frame_id);
  localizer_->add_reflectors(
      from_ros(message.header.stamp),
      reflector_observations(message, velocity_, params_.localizer.base_T_laser,
                             params_.localizer.reflectors));
  seen(began);
}

void LocalizerNodelet::seen(double began) {
  const LocalizerReport& state = localizer_->state();
  diagnostics_->refused(state.input);
  const double ended = steady_now();
  diagnostics_->scanned(ended, ended - began);
  if (state.map_T_base && !placed_.empty() && placed_.back().stamp == state.stamp) {
    // What was told before the scan is not as good, even if tf knows more of it.
    placed_.erase(placed_.begin(), std::prev(placed_.end()));
    placed_.back().map_T_base = state.map_T_base->pose;
  }
  publish_sight();
}

void LocalizerNodelet::on_timer() {
  if (newest_) localizer_->check(now());
  const LocalizerReport& state = localizer_->state();
  if (told_ != std::make_pair(state.status, state.reason)) publish_status();
  if (!state.map_T_base) forget_way();
  place_map();
  if (!params_.publish_tf) return;
  if (const auto transform = transform_->at(ros::Time::now())) {
    broadcaster_->sendTransform(*transform);
  }
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::LocalizerNodelet, nodelet::Nodelet)
