// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "keypoint_detector_nodelet.hpp"

#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/features/feature_extractor_fields.hpp"
#include "falko_slam/ros_bridge/feature_conversion.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/reconfigure.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"
#include "steady_now.hpp"

namespace falko_slam {
void KeypointDetectorNodelet::onInit() {
  load_parameters();
  ros::NodeHandle& node = getNodeHandle();
  features_ = node.advertise<FeatureArray>(topics::kFeatures, kQueue);
  markers_ = node.advertise<visualization_msgs::MarkerArray>(topics::kFeatureMarkers, kQueue);
  cloud_ = node.advertise<sensor_msgs::PointCloud2>(topics::kKeypointCloud, kQueue);

  diagnostics_ = std::make_unique<ScanDiagnostics>(
      TopicWatch(heard_topic<sensor_msgs::LaserScan>(node.resolveName(topics::kScan)),
                 steady_now()),
      steady_now());
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
  updater_->setHardwareID("none");
  updater_->add("keypoint detection", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    diagnostics_->report(status, steady_now());
  });
  // On the wall clock: silence must be told of even when simulated time stands still.
  diagnostics_timer_ = node.createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_->force_update(); });

  const ros::NodeHandle falko(getPrivateNodeHandle(), "falko");
  reconfigure_ = std::make_unique<dynamic_reconfigure::Server<KeypointDetectorConfig>>(falko);
  reconfigure_->setCallback(
      [this](KeypointDetectorConfig& config, std::uint32_t) { on_reconfigure(config); });
  constexpr std::uint32_t kRecent = 10;  // older keypoints are of no use
  scans_ = node.subscribe(topics::kScan, kRecent, &KeypointDetectorNodelet::on_scan, this);
}

void KeypointDetectorNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  ParameterReader reader(parameter_tree(node), node.getNamespace());
  FeatureExtractorParams params;
  try {
    reader.field("base_frame", base_frame_);
    visit_feature_extractor_fields(params, reader);
    extractor_ = std::make_unique<FeatureExtractor>(params);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : reader.unknown({"num_worker_threads", "diagnostic_period"})) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
  if (!base_frame_.empty()) mount_ = std::make_unique<LaserMount>(base_frame_);
}

void KeypointDetectorNodelet::on_reconfigure(KeypointDetectorConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  FeatureExtractorParams params = extractor_->params();
  ReconfigureReader reader(message);
  try {
    visit_falko_fields(params.falko, reader);
    extractor_ = std::make_unique<FeatureExtractor>(params);
  } catch (const std::invalid_argument& error) {
    NODELET_ERROR_STREAM("new parameters refused, the old ones stay: " << error.what());
    ReconfigureWriter writer;
    visit_falko_fields(extractor_->params().falko, writer);
    message = writer.config();
    config.__fromMessage__(message);
  }
}

void KeypointDetectorNodelet::look_up_mount(const std::string& laser_frame) {
  const auto upside_down = mount_->upside_down(laser_frame);
  diagnostics_->warn(upside_down ? ""
                                 : "no transform from " + laser_frame + " to " + base_frame_ +
                                       ": mount of the laser unknown");
  if (!upside_down) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "no transform from "
                                                     << laser_frame << " to " << base_frame_
                                                     << ": taking scan/upside_down as it is set");
    return;
  }
  FeatureExtractorParams params = extractor_->params();
  if (*upside_down == params.scan.upside_down) return;
  params.scan.upside_down = *upside_down;
  extractor_ = std::make_unique<FeatureExtractor>(params);
}

void KeypointDetectorNodelet::on_scan(const sensor_msgs::LaserScanConstPtr& message) {
  const double begin = steady_now();
  if (mount_) look_up_mount(message->header.frame_id);
  const ScanReport report = extractor_->extract(as_raw_scan(*message));
  warn_about(report);
  publish(message->header);
  diagnostics_->add(report, extractor_->features().size(), begin, steady_now() - begin);
}

void KeypointDetectorNodelet::warn_about(const ScanReport& report) {
  if (!report.usable()) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "unusable scan: " << describe(report));
  } else if (report.count(BeamStatus::kValid) == 0 || report.angles_disagree() ||
             report.surplus_beams > 1) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "strange scan: " << describe(report));
  }
}

void KeypointDetectorNodelet::publish(const std_msgs::Header& header) {
  const auto features = boost::make_shared<FeatureArray>(to_message(*extractor_, header));
  features_.publish(features);
  if (markers_.getNumSubscribers() > 0) markers_.publish(to_markers(*features));
  if (cloud_.getNumSubscribers() > 0) cloud_.publish(to_cloud(*features));
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::KeypointDetectorNodelet, nodelet::Nodelet)
