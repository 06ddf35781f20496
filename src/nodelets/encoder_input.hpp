// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <functional>

#include "falko_slam/ros_bridge/topic_watch.hpp"
#include "falko_slam/ros_bridge/vehicle_params.hpp"

namespace falko_slam {

/// The encoders of a vehicle, in whichever messages they come. Calls come from the node's queue.
class EncoderInput {
 public:
  EncoderInput(ros::NodeHandle node, const VehicleParams& vehicle,
               const std::function<void(const EncoderReading&)>& received);

  const HeardTopic& topic() const { return topic_; }

 private:
  ros::Subscriber subscriber_;
  HeardTopic topic_;
};

}  // namespace falko_slam
