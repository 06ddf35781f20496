// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <falko_slam/FeatureArray.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <map>
#include <optional>
#include <string>

#include "spin_until.hpp"
#include "support/seeds.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace test {

/// What a closed laser sees of the office, in the way of the SICK NAV350's driver.
inline sensor_msgs::LaserScan office_scan(std::size_t beams) {
  SimulatedLaserParams laser;
  laser.beams = beams;
  laser.angle_increment = kTwoPi / static_cast<double>(beams);
  auto random = seeded_random();
  sensor_msgs::LaserScan scan;
  scan.header.frame_id = "laser";
  scan.angle_min = static_cast<float>(laser.angle_min);
  scan.angle_max = static_cast<float>(-laser.angle_min);
  scan.angle_increment = static_cast<float>(laser.angle_increment);
  scan.range_min = 0.05F;
  scan.range_max = static_cast<float>(laser.range_max);
  scan.ranges = simulate_ranges(office_scene(), {-3.0, -1.0, 0.4}, laser, random);
  return scan;
}

/// Sends scans to the detector of a namespace and waits for its answers.
class DetectorClient {
 public:
  explicit DetectorClient(const std::string& name) : node_(name) {
    scans_ = node_.advertise<sensor_msgs::LaserScan>("scan", 10);
    features_ =
        node_.subscribe<FeatureArray>("features", 10, [this](const FeatureArrayConstPtr& message) {
          answers_[message->header.stamp] = *message;
        });
  }

  bool connected() {
    return spin_until(
        [this] { return scans_.getNumSubscribers() > 0 && features_.getNumPublishers() > 0; });
  }

  /// Empty if no answer comes. Every scan gets a stamp of its own.
  std::optional<FeatureArray> ask(sensor_msgs::LaserScan scan) {
    stamp_ += ros::Duration(0.125);
    return ask_at(stamp_, std::move(scan));
  }
  std::optional<FeatureArray> ask_at(const ros::Time& stamp, sensor_msgs::LaserScan scan) {
    scan.header.stamp = stamp;
    answers_.erase(stamp);
    scans_.publish(scan);
    if (!spin_until([&] { return answers_.count(stamp) > 0; })) return std::nullopt;
    return answers_[stamp];
  }

  ros::NodeHandle& node() { return node_; }

 private:
  ros::NodeHandle node_;
  ros::Publisher scans_;
  ros::Subscriber features_;
  std::map<ros::Time, FeatureArray> answers_;
  ros::Time stamp_ = ros::Time(1000.0);
};

}  // namespace test
}  // namespace falko_slam
