// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the simulator starts, and its one thread.
#include "nav350_simulator_nodelet.hpp"

#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include <pluginlib/class_list_macros.hpp>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/recorded_driver.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "node_constants.hpp"
#include "real_time.hpp"

namespace falko_slam {
namespace {

Time now_of_ros() { return from_ros(ros::Time::now()); }

}  // namespace

Nav350SimulatorNodelet::~Nav350SimulatorNodelet() {
  drive_commands_.shutdown();
  reset_.shutdown();
  diagnostics_timer_.stop();
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Nav350SimulatorNodelet::onInit() {
  // All that may throw comes first.
  load_parameters();
  load_scenario();
  advertise();
  begin(is_clock_ ? kSimulationStart : now_of_ros());
  ros::NodeHandle& node = getNodeHandle();
  if (commands_) {
    drive_commands_ =
        node.subscribe(topics::kDriveCommand, kQueue, &Nav350SimulatorNodelet::on_command, this);
    command_watch_ = std::make_unique<TopicWatch>(
        heard_topic<DriveCommand>(drive_commands_.getTopic()), ros::SteadyTime::now().toSec());
    command_watch_->keep_from_console();
  }
  reset_ = getPrivateNodeHandle().advertiseService(topics::kReset,
                                                   &Nav350SimulatorNodelet::on_reset, this);
  updater_ = std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
  updater_->setHardwareID("none");
  updater_->add("simulation",
                [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  diagnostics_timer_ = node.createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_->force_update(); });
  thread_ = std::thread([this] { run(); });
}

void Nav350SimulatorNodelet::load_parameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  std::vector<std::string> unknown;
  try {
    params_ = read_simulation_node_params(parameter_tree(node), node.getNamespace(), unknown);
    is_clock_ = ros::Time::isSimTime();
    if (!is_clock_ && params_.rate != 1.0) {
      throw std::invalid_argument("rate: other than 1 needs use_sim_time");
    }
  } catch (const std::invalid_argument& error) {
    NODELET_FATAL_STREAM("bad parameter: " << error.what());
    throw;
  }
  for (const std::string& name : unknown) {
    NODELET_WARN_STREAM("parameter " << name << " is not known and has no effect");
  }
}

void Nav350SimulatorNodelet::load_scenario() {
  try {
    scenario_ = read_scenario(params_.scenario);
    if (params_.drive == DriveSource::kScenario && scenario_.drive.empty()) {
      throw std::runtime_error(params_.scenario +
                               ": has no drive, but the parameter drive asks for it");
    }
    if (params_.drive == DriveSource::kBag) make_driver();  // to know at once that it can be read
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM(error.what());
    throw;
  }
}

void Nav350SimulatorNodelet::make_driver() {
  commands_.reset();
  if (params_.drive == DriveSource::kScenario) {
    driver_ = scenario_driver(scenario_.drive, scenario_.vehicle);
  } else if (params_.drive == DriveSource::kBag) {
    RecordedDrive drive = read_drive(params_.drive_bag, params_.drive_topic, scenario_.vehicle);
    if (drive.first_drive_ticks) scenario_.vehicle.first_drive_ticks = *drive.first_drive_ticks;
    driver_ = std::move(drive.driver);
  } else {
    commands_ = std::make_shared<CommandedDriver>(
        from_seconds(scenario_.vehicle.actuators.command_timeout));
    driver_ = commands_;
  }
}

void Nav350SimulatorNodelet::advertise() {
  ros::NodeHandle& node = getNodeHandle();
  scans_ = node.advertise<sensor_msgs::LaserScan>(topics::kScan, kQueue);
  reflectors_ = node.advertise<ReflectorArray>(topics::kReflectors, kQueue);
  encoders_ = node.advertise<TricycleEncoders>(topics::kEncoders, kQueue);
  joints_ = node.advertise<sensor_msgs::JointState>(topics::kJointStates, kQueue);
  odometry_ = node.advertise<nav_msgs::Odometry>(topics::kOdometry, kQueue);
  truth_ = node.advertise<geometry_msgs::PoseStamped>(topics::kGroundTruth, kQueue);
  true_path_ = node.advertise<nav_msgs::Path>(topics::kGroundTruthPath, 1, true);
  markers_ = node.advertise<visualization_msgs::MarkerArray>(topics::kWorldMarkers, 1, true);
  if (is_clock_) clock_ = node.advertise<rosgraph_msgs::Clock>("/clock", kQueue);
  transforms_ = std::make_unique<tf2_ros::TransformBroadcaster>();
  static_transforms_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
}

void Nav350SimulatorNodelet::begin(Time now) {
  make_driver();
  simulation_ =
      std::make_unique<Simulation>(scenario_, now, static_cast<std::uint64_t>(params_.seed));
  messenger_ = std::make_unique<SimulationMessenger>(scenario_, params_.frames);
  drive_is_over_ = false;
  path_ = nav_msgs::Path();
  path_.header.frame_id = params_.frames.world;
  if (params_.publish_tf) static_transforms_->sendTransform(messenger_->mount(now).transforms);
}

// What happens in a period is worked out while it lasts and published when it ends.
void Nav350SimulatorNodelet::run() {
  // A clock of its own may lose time; stamps of the machine's time may not stay behind it.
  constexpr auto kClockLoses = std::chrono::milliseconds(500);
  constexpr auto kNeverGivesUp = std::chrono::hours(1000);
  RealTime real_time(params_.rate,
                     is_clock_ ? RealTime::Clock::duration(kClockLoses) : kNeverGivesUp);
  publish(first_messages());
  while (!stop_ && ros::ok()) {
    const SimulationMessages messages = advance();
    real_time.wait_for(period_);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      seconds_late_ = real_time.seconds_late();
      given_up_ = real_time.given_up();
    }
    publish(messages);
  }
}

SimulationMessages Nav350SimulatorNodelet::first_messages() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return messenger_->of(simulation_->state());
}

SimulationMessages Nav350SimulatorNodelet::advance() {
  const std::lock_guard<std::mutex> lock(mutex_);
  period_ = simulation_->period();
  auto input = driver_->next(simulation_->vehicle(), period_);
  if (!input) {
    if (!drive_is_over_) NODELET_INFO("the drive is over");
    drive_is_over_ = true;
    input = WheelCommand{0.0, simulation_->vehicle().steering()};
  }
  return messenger_->of(simulation_->step(*input));
}

}  // namespace falko_slam

PLUGINLIB_EXPORT_CLASS(falko_slam::Nav350SimulatorNodelet, nodelet::Nodelet)
