// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <falko_slam/DriveCommand.h>
#include <falko_slam/ReflectorArray.h>
#include <falko_slam/TricycleEncoders.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>

#include <string>
#include <vector>

#include "spin_until.hpp"

namespace falko_slam {
namespace test {

/// Hears what a simulated vehicle publishes and leads it.
class SimulatorClient {
 public:
  explicit SimulatorClient(const std::string& name) : node(name) {
    command_ = node.advertise<DriveCommand>("drive_command", 10);
    collect("scan", scans);
    collect("reflectors", reflectors);
    collect("encoders", encoders);
    collect("joint_states", joints);
    collect("odom", odometry);
    collect("ground_truth", truth);
  }

  /// Leads the vehicle for so long [s], ten commands a second.
  void lead(double wheel_speed, double steering, double seconds) {
    const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(seconds);
    while (ros::SteadyTime::now() < end) {
      DriveCommand message;
      message.header.stamp = ros::Time::now();
      message.wheel_speed = wheel_speed;
      message.steering = steering;
      command_.publish(message);
      spin_for(0.1);
    }
  }
  bool leads() const { return command_.getNumSubscribers() > 0; }

  ros::NodeHandle node;
  std::vector<sensor_msgs::LaserScan> scans;
  std::vector<ReflectorArray> reflectors;
  std::vector<TricycleEncoders> encoders;
  std::vector<sensor_msgs::JointState> joints;
  std::vector<nav_msgs::Odometry> odometry;
  std::vector<geometry_msgs::PoseStamped> truth;

 private:
  template <class Message>
  void collect(const std::string& topic, std::vector<Message>& messages) {
    subscribers_.push_back(node.subscribe<Message>(
        topic, 1000, [&messages](const boost::shared_ptr<const Message>& message) {
          messages.push_back(*message);
        }));
  }

  ros::Publisher command_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace test
}  // namespace falko_slam
