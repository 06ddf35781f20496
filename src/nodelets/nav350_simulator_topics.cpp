// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the simulator publishes and hears.
#include <rosgraph_msgs/Clock.h>
#include <visualization_msgs/MarkerArray.h>

#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/ros_bridge/world_markers.hpp"
#include "nav350_simulator_nodelet.hpp"
#include "node_constants.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kLongestPath = 20000;  // then its older half is forgotten

}  // namespace

void Nav350SimulatorNodelet::publish(const SimulationMessages& messages) {
  if (is_clock_) {
    rosgraph_msgs::Clock clock;
    clock.clock = messages.encoders.header.stamp;
    clock_.publish(clock);
  }
  if (params_.publish_tf) transforms_->sendTransform(messages.odom_T_base.transforms);
  if (params_.publish_world_tf) transforms_->sendTransform(messages.world_T_odom.transforms);
  encoders_.publish(messages.encoders);
  joints_.publish(messages.joints);
  odometry_.publish(messages.odometry);
  truth_.publish(messages.truth);
  for (const sensor_msgs::LaserScan& scan : messages.scans) {
    scans_.publish(boost::make_shared<sensor_msgs::LaserScan>(scan));
  }
  for (const ReflectorArray& found : messages.reflectors) reflectors_.publish(found);
  publish_slowly(messages.truth);
}

void Nav350SimulatorNodelet::publish_slowly(const geometry_msgs::PoseStamped& truth) {
  const std::lock_guard<std::mutex> lock(mutex_);
  extend_path(path_, truth);
  if (path_.poses.size() > kLongestPath) {
    path_.poses.erase(path_.poses.begin(), path_.poses.begin() + kLongestPath / 2);
  }
  const double seconds = (truth.header.stamp - last_slow_).toSec();
  if (seconds >= 0.0 && seconds < 1.0) return;
  last_slow_ = truth.header.stamp;
  path_.header.stamp = truth.header.stamp;
  const double elapsed = to_seconds(from_ros(truth.header.stamp) - simulation_->start());
  true_path_.publish(path_);
  markers_.publish(world_markers(scenario_.world, elapsed, path_.header));
}

void Nav350SimulatorNodelet::on_command(const DriveCommandConstPtr& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  command_watch_->heard(ros::SteadyTime::now().toSec());
  try {
    commands_->command({message->wheel_speed, message->steering}, simulation_->time());
  } catch (const std::invalid_argument& error) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "drive command refused: " << error.what());
  }
}

bool Nav350SimulatorNodelet::on_reset(std_srvs::Trigger::Request&,
                                      std_srvs::Trigger::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  begin(simulation_->time());
  response.success = 1;
  response.message = "the vehicle is at its start";
  return true;
}

// A vehicle may stand without anybody who leads it, but not for want of the right messages.
void Nav350SimulatorNodelet::report_commands(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::string trouble = command_watch_->trouble(ros::SteadyTime::now().toSec());
  if (commands_->is_led(simulation_->time())) return;
  const bool wrong = command_watch_->cause() == SilenceCause::kWrongType;
  status.summary(
      wrong ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
      "nobody leads it: it halts" + (trouble.empty() ? "" : "; " + trouble));
}

void Nav350SimulatorNodelet::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.summary(diagnostic_msgs::DiagnosticStatus::OK, "running");
  if (drive_is_over_) status.summary(diagnostic_msgs::DiagnosticStatus::OK, "the drive is over");
  if (command_watch_) report_commands(status);
  if (seconds_late_ > to_seconds(period_)) {
    status.summary(diagnostic_msgs::DiagnosticStatus::WARN, "slower than real time");
  }
  status.add("scenario", scenario_.name);
  status.add("wheel speed [m/s]", simulation_->vehicle().wheel_speed());
  status.add("steering [rad]", simulation_->vehicle().steering());
  status.add("late [s]", seconds_late_);
  status.add("times that lost time was given up", given_up_);
}

}  // namespace falko_slam
