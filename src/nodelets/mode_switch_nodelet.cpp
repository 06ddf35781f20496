// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the ModeSwitch nodelet starts and looks after the nodelet of the mode.
#include "mode_switch_nodelet.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/ros_bridge/localizer_node_params.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/topics.hpp"

namespace falko_slam {
namespace {

constexpr double kTroublePeriod = 10.0;  // [s]

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

VehicleMode other(VehicleMode mode) {
  return mode == VehicleMode::kMapping ? VehicleMode::kLocalization : VehicleMode::kMapping;
}

}  // namespace

ModeSwitchNodelet::~ModeSwitchNodelet() {
  if (thread_) thread_->stop();
  timer_.stop();
  set_mode_.shutdown();
  poses_.shutdown();
}

void ModeSwitchNodelet::onInit() {
  load_parameters();
  start();
  thread_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  thread_->start();
}

void ModeSwitchNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_mode_switch_params(parameter_tree(node), node.getNamespace(), unknown);
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
  mode_ = params_.mode;
  autosaved_ = ros::SteadyTime::now();
}

void ModeSwitchNodelet::start() {
  ros::NodeHandle node(getNodeHandle()), private_node(getPrivateNodeHandle());
  node.setCallbackQueue(&queue_);
  private_node.setCallbackQueue(&queue_);
  manager_ = std::make_unique<ManagerClient>(
      node, params_.manager,
      std::vector<std::string>{
          topics::kScan, topics::kEncoders, topics::kJointStates, topics::kOdometry,
          topics::kReflectors, topics::kInitialPose, topics::kPose, topics::kLocalizedOdometry,
          topics::kLandmarks, topics::kMarkers, topics::kStatus, topics::kMap, topics::kMapMetadata,
          topics::kPath, topics::kGraphMarkers, topics::kConstraints});
  const std::string localizer = nodelet_of(VehicleMode::kLocalization).name;
  transforms_ = std::make_unique<tf2_ros::TransformListener>(buffer_, node, true);
  handover_ = std::make_unique<PoseHandover>(
      buffer_, node.param(localizer + "/odom_frame", LocalizerNodeParams().odom_frame),
      node.param(localizer + "/base_frame", LocalizerNodeParams().base_frame));
  poses_ = node.subscribe(topics::kLocalizedOdometry, 1, &ModeSwitchNodelet::on_pose, this);
  mode_publisher_ = private_node.advertise<std_msgs::String>(topics::kMode, 1, true);
  publish_mode("none");
  set_mode_ =
      private_node.advertiseService(topics::kSetMode, &ModeSwitchNodelet::on_set_mode, this);
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, private_node, getName());
  updater_->setHardwareID("none");
  updater_->add("mode",
                [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  timer_ = node.createWallTimer(ros::WallDuration(params_.check_period),
                                [this](const ros::WallTimerEvent&) { on_timer(); });
}

ManagedNodelet ModeSwitchNodelet::nodelet_of(VehicleMode mode) const {
  const bool maps = mode == VehicleMode::kMapping;
  return {getNodeHandle().resolveName(maps ? params_.mapping_node : params_.localization_node),
          maps ? "falko_slam/PoseGraph" : "falko_slam/Localizer"};
}

std::string ModeSwitchNodelet::file_parameter(VehicleMode mode) const {
  return nodelet_of(mode).name + (mode == VehicleMode::kMapping ? "/state" : "/map_file");
}

void ModeSwitchNodelet::publish_mode(const std::string& mode) {
  if (published_ == mode) return;
  published_ = mode;
  std_msgs::String message;
  message.data = mode;
  mode_publisher_.publish(message);
}

void ModeSwitchNodelet::on_pose(const nav_msgs::Odometry& message) {
  pose_.header = message.header;
  pose_.pose = message.pose;
}

void ModeSwitchNodelet::on_timer() {
  handover_->follow();
  try {
    supervise();
    autosave();
  } catch (const std::runtime_error& error) {
    trouble_ = error.what();
    NODELET_ERROR_STREAM_THROTTLE(kTroublePeriod, trouble_);
  }
  publish_mode(runs_ ? name_of(mode_, vehicle_mode_names()) : "none");
  updater_->force_update();
}

void ModeSwitchNodelet::supervise() {
  runs_ = false;
  const auto loaded = manager_->loaded();
  manager_answers_ = loaded.has_value();
  if (!loaded) return;
  const std::string stranger = nodelet_of(other(mode_)).name;
  if (contains(*loaded, stranger)) {
    NODELET_WARN_STREAM(stranger << " runs, too, and is unloaded: the mode is "
                                 << name_of(mode_, vehicle_mode_names()));
    manager_->unload(stranger);
  }
  if (!contains(*loaded, nodelet_of(mode_).name)) {
    manager_->load(nodelet_of(mode_));
    ++loads_;
    NODELET_INFO_STREAM(nodelet_of(mode_).name << " loaded into " << manager_->manager());
  }
  runs_ = true;
  trouble_.clear();
}

void ModeSwitchNodelet::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const std::string mode = name_of(mode_, vehicle_mode_names());
  const double ago = (ros::SteadyTime::now() - refused_).toSec();
  status.summary(DiagnosticStatus::OK, mode);
  if (!refusal_.empty() && ago < params_.refusal_shown_for) {
    status.summary(DiagnosticStatus::WARN, mode + ", and stays so: " + refusal_);
  }
  if (!unsaved_.empty()) status.mergeSummary(DiagnosticStatus::WARN, unsaved_);
  if (!trouble_.empty()) status.summary(DiagnosticStatus::ERROR, trouble_);
  if (!manager_answers_) {
    status.summary(DiagnosticStatus::ERROR,
                   "nodelet manager " + manager_->manager() + " does not answer");
  }
  std::string file;
  ros::param::get(file_parameter(mode_), file);
  status.add("mode", mode);
  status.add("nodelet", nodelet_of(mode_).name);
  status.add("file", file);
  status.add("loaded without being asked, times", loads_);
  status.add("last refusal", refusal_.empty() ? "none" : refusal_);
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::ModeSwitchNodelet, nodelet::Nodelet)
