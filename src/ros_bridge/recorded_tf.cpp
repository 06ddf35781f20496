// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_tf.hpp"

#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include "falko_slam/ros_bridge/laser_pose.hpp"

namespace falko_slam {

RecordedTf::RecordedTf(const rosbag::Bag& bag) : buffer_(ros::DURATION_MAX) {
  for (const char* topic : {"/tf", "tf", "/tf_static", "tf_static"}) read(bag, topic);
}

void RecordedTf::read(const rosbag::Bag& bag, const std::string& topic) {
  const bool is_static = topic.find("static") != std::string::npos;
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    if (!message) continue;
    for (geometry_msgs::TransformStamped transform : message->transforms) {
      transform.header.frame_id = tf_frame(transform.header.frame_id);
      transform.child_frame_id = tf_frame(transform.child_frame_id);
      buffer_.setTransform(transform, "bag", is_static);
    }
  }
}

}  // namespace falko_slam
