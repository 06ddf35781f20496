// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/ReflectorArray.h>
#include <falko_slam/TricycleEncoders.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/simulation/simulation.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

/// Names of the frames in which a simulated vehicle speaks.
struct SimulationFrames {
  std::string world = "world";  ///< that of the scenario, for the truth only
  std::string odom = "odom";
  std::string base = "base_link";
  std::string laser = "laser";
};

/// What a vehicle publishes after a control period.
struct SimulationMessages {
  std::vector<sensor_msgs::LaserScan> scans;  ///< as the driver of the scanner does
  std::vector<ReflectorArray> reflectors;     ///< one for each scan of a scanner with intensities
  TricycleEncoders encoders;
  sensor_msgs::JointState joints;
  nav_msgs::Odometry odometry;       ///< as the vehicle's controller knows it
  tf2_msgs::TFMessage odom_T_base;   ///< the same
  geometry_msgs::PoseStamped truth;  ///< of base_link
  tf2_msgs::TFMessage world_T_odom;  ///< as a perfect localizer would send it
};

/// Turns the steps of a simulation into messages. The vehicle's odometry uses the parameters that
/// its controller believes in, and begins at zero.
class SimulationMessenger {
 public:
  SimulationMessenger(const Scenario& scenario, const SimulationFrames& frames);

  SimulationMessages of(const SimulationStep& step);

  /// base_link to laser, as the vehicle's controller believes.
  tf2_msgs::TFMessage mount(Time stamp) const;

 private:
  ReflectorArray reflectors_of(const SimulationStep::Scan& scan) const;
  void add_odometry(const SimulationStep& step, SimulationMessages& messages);

  LaserModel laser_;
  Pose2 base_T_laser_;
  double reflector_diameter_;
  SimulationFrames frames_;
  TricycleOdometry odometry_;
  JointStateSource joints_;
};

/// Adds a pose that is at least 0.1 m from the path's last one.
void extend_path(nav_msgs::Path& path, const geometry_msgs::PoseStamped& pose);

}  // namespace falko_slam
