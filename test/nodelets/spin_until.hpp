// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace falko_slam {
namespace test {

/// How many times as long as usual tests wait: the environment's FALKO_SLAM_PATIENCE, else once.
/// Sanitizers make programs slow.
inline double patience() {
  const char* const factor = std::getenv("FALKO_SLAM_PATIENCE");
  return factor == nullptr ? 1.0 : std::max(1.0, std::atof(factor));
}

/// Spins for so long, whatever the patience [s].
inline void spin_for(double seconds) {
  const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(seconds);
  while (ros::SteadyTime::now() < end && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
}

/// Spins until the condition holds; false after ten seconds, or what is given, times patience().
inline bool spin_until(const std::function<bool()>& condition, double seconds = 10.0) {
  const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(patience() * seconds);
  while (!condition() && ros::SteadyTime::now() < deadline && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return condition();
}

}  // namespace test
}  // namespace falko_slam
