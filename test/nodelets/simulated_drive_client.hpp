// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/TricycleEncoders.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "falko_slam/ros_bridge/simulation_messages.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/simulation/driver.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "falko_slam/simulation/simulation.hpp"
#include "spin_until.hpp"

namespace falko_slam {
namespace test {

/// A simulated vehicle that publishes what its test wants to be heard, and is the clock.
class SimulatedDriveClient {
 public:
  SimulatedDriveClient(const std::string& scenario, Time start)
      : scenario_(read_scenario(scenario)), messenger_(scenario_, {}) {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 100);
    encoders_ = node_.advertise<TricycleEncoders>("encoders", 100);
    scans_ = node_.advertise<sensor_msgs::LaserScan>("scan", 100);
    transforms_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    begin(start);
  }

  /// From the scenario's start, at this time, which may be earlier than now.
  void begin(Time start) {
    driver_ = scenario_driver(scenario_.drive, scenario_.vehicle);
    simulation_ = std::make_unique<Simulation>(scenario_, start, 1);
    messenger_ = SimulationMessenger(scenario_, {});
  }

  bool is_heard() const {
    return encoders_.getNumSubscribers() > 0 && scans_.getNumSubscribers() > 0;
  }

  /// So much time passes [s], faster than it does.
  void pass(double seconds) {
    pass_until([] { return false; }, seconds);
  }
  /// Until then, or so much time has passed; says whether it is so.
  bool pass_until(const std::function<bool()>& done, double seconds) {
    const Time end = simulation_->time() + from_seconds(seconds);
    while (simulation_->time() < end && !done() && ros::ok()) {
      step();
      spin_for(kStep * patience());
    }
    return done();
  }

  Time now() const { return simulation_->time(); }
  const Pose2& truth() const { return truth_; }
  const VehicleModel& vehicle() const { return scenario_.vehicle; }

  bool sends_encoders = true;
  bool sends_scans = true;

 private:
  // Of real time, for one control period of 0.02 s, times the patience [s].
  static constexpr double kStep = 0.004;

  void step() {
    const auto input = driver_->next(simulation_->vehicle(), simulation_->period());
    const SimulationStep step =
        simulation_->step(input ? *input : DriveInput(WheelCommand{0.0, 0.0}));
    truth_ = step.world_T_base;
    const SimulationMessages messages = messenger_.of(step);
    rosgraph_msgs::Clock clock;
    clock.clock = to_ros(simulation_->time());
    clock_.publish(clock);
    if (sends_encoders) {
      transforms_.publish(messages.odom_T_base);
      encoders_.publish(messages.encoders);
    }
    if (!sends_scans) return;
    for (const sensor_msgs::LaserScan& scan : messages.scans) scans_.publish(scan);
  }

  ros::NodeHandle node_;
  Scenario scenario_;
  SimulationMessenger messenger_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<Simulation> simulation_;
  Pose2 truth_;
  ros::Publisher clock_, encoders_, scans_, transforms_;
};

}  // namespace test
}  // namespace falko_slam
