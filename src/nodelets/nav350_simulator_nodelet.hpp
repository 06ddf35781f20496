// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <falko_slam/DriveCommand.h>
#include <nav_msgs/Path.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "falko_slam/ros_bridge/simulation_messages.hpp"
#include "falko_slam/ros_bridge/simulation_node_params.hpp"
#include "falko_slam/ros_bridge/topic_watch.hpp"
#include "falko_slam/simulation/commanded_driver.hpp"

namespace falko_slam {

/// A simulated vehicle with a scanner, in real time: a wrapper of Simulation.
///
/// Subscribes `drive_command`; publishes what a vehicle does: `scan`, `reflectors`, `encoders`,
/// `joint_states`, `odom` and tf; and what only a simulation knows: `ground_truth`,
/// `ground_truth_path`, `world_markers`. Where use_sim_time is set it is the clock. Service `reset`
/// puts the vehicle back. Parameters: config/nav350_simulator.yaml.
///
/// A thread of its own advances the simulation, one control period after the other; `mutex_` guards
/// what it shares with the callbacks.
class Nav350SimulatorNodelet : public nodelet::Nodelet {
 public:
  ~Nav350SimulatorNodelet() override;

 private:
  void onInit() override;

  void load_parameters();
  void load_scenario();
  void advertise();
  void make_driver();
  /// The vehicle at its start, at this time.
  void begin(Time now);
  void run();
  SimulationMessages first_messages();
  SimulationMessages advance();
  void publish(const SimulationMessages& messages);
  /// What needs no more than once a second.
  void publish_slowly(const geometry_msgs::PoseStamped& truth);
  void on_command(const DriveCommandConstPtr& message);
  bool on_reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  void report_commands(diagnostic_updater::DiagnosticStatusWrapper& status);

  SimulationNodeParams params_;
  bool is_clock_ = false;
  std::mutex mutex_;  // of the following
  Scenario scenario_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SimulationMessenger> messenger_;
  std::shared_ptr<CommandedDriver> commands_;  // null: nobody's commands count
  std::shared_ptr<Driver> driver_;
  bool drive_is_over_ = false;
  Duration period_{};
  double seconds_late_ = 0.0;
  std::uint64_t given_up_ = 0;
  nav_msgs::Path path_;

  ros::Time last_slow_;
  std::atomic<bool> stop_{false};
  std::unique_ptr<tf2_ros::TransformBroadcaster> transforms_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> static_transforms_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::Publisher scans_, reflectors_, encoders_, joints_, odometry_, truth_, true_path_, markers_,
      clock_;
  ros::Subscriber drive_commands_;
  std::unique_ptr<TopicWatch> command_watch_;  // guarded, too
  ros::ServiceServer reset_;
  ros::WallTimer diagnostics_timer_;
  std::thread thread_;
};

}  // namespace falko_slam
