// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "encoder_input.hpp"

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"

namespace falko_slam {
EncoderInput::EncoderInput(ros::NodeHandle node, const VehicleParams& vehicle,
                           const std::function<void(const EncoderReading&)>& received) {
  if (vehicle.encoder_source == EncoderSource::kTicks) {
    subscriber_ = node.subscribe<TricycleEncoders>(
        topics::kEncoders, kMotionQueue,
        [received](const TricycleEncodersConstPtr& message) { received(from_message(*message)); });
    topic_ = heard_topic<TricycleEncoders>(subscriber_.getTopic());
    return;
  }
  subscriber_ = node.subscribe<sensor_msgs::JointState>(
      topics::kJointStates, kMotionQueue,
      [received, joints = joints_of(vehicle)](const sensor_msgs::JointStateConstPtr& message) {
        if (const auto reading = from_message(*message, joints)) return received(*reading);
        ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "joint state without usable positions of "
                                                     << kDriveJoint << " and " << kSteerJoint);
      });
  topic_ = heard_topic<sensor_msgs::JointState>(subscriber_.getTopic());
}

}  // namespace falko_slam
