// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the Calibration nodelet starts and ends, and what it hears.
#include "calibration_nodelet.hpp"

#include <falko_slam/DriveCommand.h>
#include <visualization_msgs/MarkerArray.h>

#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/reflector_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"
#include "steady_now.hpp"

namespace falko_slam {
CalibrationNodelet::~CalibrationNodelet() {
  if (thread_) thread_->stop();
  try {
    abort_drive();
  } catch (const std::exception& error) {
    NODELET_ERROR("the drive is not aborted: %s", error.what());
  }
  control_timer_.stop();
  diagnostics_timer_.stop();
  encoders_.reset();
  scans_.shutdown();
  compute_.shutdown();
  transforms_.reset();
}

void CalibrationNodelet::abort_drive() {
  if (!session_ || !ros::ok()) return;
  session_->abort("the node ends");
  send(session_->next(now_));
  CalibrateResult result;
  result.message = session_->driver().reason();
  server_->setAborted(result, result.message);
}

void CalibrationNodelet::onInit() {
  // All that may throw comes first.
  load_parameters();
  start_listening();
  start_serving();
  thread_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  thread_->start();
}

void CalibrationNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_calibration_node_params(parameter_tree(node), node.getNamespace(), unknown);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
}

void CalibrationNodelet::start_listening() {
  ros::NodeHandle node(getNodeHandle());
  node.setCallbackQueue(&queue_);
  transforms_ = std::make_unique<tf2_ros::TransformListener>(buffer_, node, false);
  encoders_ = std::make_unique<EncoderInput>(
      node, params_.vehicle, [this](const EncoderReading& reading) { on_reading(reading); });
  if (params_.session.recorder.egomotion == EgomotionSource::kReflectors) {
    scans_ = node.subscribe(topics::kReflectors, kQueue, &CalibrationNodelet::on_reflectors, this);
  } else {
    scans_ = node.subscribe(topics::kScan, kQueue, &CalibrationNodelet::on_scan, this);
  }
  const HeardTopic scans = params_.session.recorder.egomotion == EgomotionSource::kReflectors
                               ? heard_topic<ReflectorArray>(scans_.getTopic())
                               : heard_topic<sensor_msgs::LaserScan>(scans_.getTopic());
  encoder_watch_ = std::make_unique<TopicWatch>(encoders_->topic(), steady_now());
  scan_watch_ = std::make_unique<TopicWatch>(scans, steady_now());
}

void CalibrationNodelet::start_serving() {
  ros::NodeHandle node(getNodeHandle()), private_node(getPrivateNodeHandle());
  node.setCallbackQueue(&queue_);
  private_node.setCallbackQueue(&queue_);
  commands_ = node.advertise<DriveCommand>(topics::kDriveCommand, kQueue);
  marker_publisher_ =
      node.advertise<visualization_msgs::MarkerArray>(topics::kCalibrationMarkers, 1, true);
  server_ = std::make_unique<Server>(node, topics::kCalibrate, false);
  server_->registerGoalCallback([this] { on_goal(); });
  server_->registerPreemptCallback([this] { on_preempt(); });
  server_->start();
  compute_ = private_node.advertiseService(topics::kComputeCalibration,
                                           &CalibrationNodelet::on_compute, this);
  control_timer_ = node.createTimer(ros::Duration(params_.control_period),
                                    [this](const ros::TimerEvent&) { on_control(); });
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, private_node, getName());
  updater_->setHardwareID("none");
  updater_->add("calibration",
                [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  diagnostics_timer_ = node.createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_->force_update(); });
}

void CalibrationNodelet::on_reading(const EncoderReading& reading) {
  ++readings_;
  encoder_watch_->heard(steady_now());
  if (!session_) return;
  session_->add(reading);
  markers_->add_pose(reading.stamp, session_->driver().start_T_base());
}

void CalibrationNodelet::on_reflectors(const ReflectorArray& message) {
  ++scan_count_;
  scan_watch_->heard(steady_now());
  if (!session_) return;
  const ReflectorObservation observation = from_message(message);
  session_->add(observation);
  markers_->set_reflectors(observation);
}

void CalibrationNodelet::on_scan(const sensor_msgs::LaserScan& message) {
  ++scan_count_;
  scan_watch_->heard(steady_now());
  if (!session_) return;
  const ScanReport report = normalize(as_raw_scan(message), params_.scan, scan_.scan);
  if (report.usable()) return session_->add(scan_);
  NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "unusable scan: " << describe(report));
}

void CalibrationNodelet::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  status.summary(DiagnosticStatus::OK, session_ ? "calibrating" : last_result_);
  for (TopicWatch* watch : {encoder_watch_.get(), scan_watch_.get()}) {
    const std::string trouble = watch->trouble(steady_now());
    if (!trouble.empty()) status.mergeSummary(DiagnosticStatus::WARN, trouble);
  }
  if (session_) {
    const CalibrationProgress progress = session_->driver().progress();
    status.add("stage", name_of(progress.stage));
    status.add("phase", name_of(progress.phase));
    status.addf("arc", "%zu of %zu", progress.arc + 1, progress.arcs);
  }
  status.add("encoder readings per second", readings_);
  status.add("scans per second", scan_count_);
  readings_ = scan_count_ = 0;
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::CalibrationNodelet, nodelet::Nodelet)
