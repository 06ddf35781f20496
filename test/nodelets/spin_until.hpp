// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>

namespace falko_slam {
namespace test {

/// Spins until the condition holds; false after ten seconds, or what is given.
inline bool spin_until(const std::function<bool()>& condition, double seconds = 10.0) {
  const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(seconds);
  while (!condition() && ros::SteadyTime::now() < deadline && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return condition();
}

}  // namespace test
}  // namespace falko_slam
