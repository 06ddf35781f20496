// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <cstddef>
#include <functional>
#include <string>

#include "falko_slam/ros_bridge/vehicle_params.hpp"

namespace falko_slam {

/// The encoders of a vehicle, in whichever messages they come. Calls come from the node's queue.
class EncoderInput {
 public:
  EncoderInput(ros::NodeHandle node, const VehicleParams& vehicle,
               std::function<void(const EncoderReading&)> received);

  std::string topic() const { return subscriber_.getTopic(); }
  std::size_t publishers() const { return subscriber_.getNumPublishers(); }

 private:
  ros::Subscriber subscriber_;
};

}  // namespace falko_slam
