// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/pose_recording.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <stdexcept>

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
Trajectory read_pose_topic(const std::string& path, const std::string& wanted) {
  try {
    const rosbag::Bag bag(path);
    const std::string topic = topic_of_type(bag, path, "geometry_msgs/PoseStamped", wanted);
    Trajectory trajectory;
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) {
      const auto message = instance.instantiate<geometry_msgs::PoseStamped>();
      if (message) trajectory.push_back({from_ros(message->header.stamp), in_plane(message->pose)});
    }
    return trajectory;
  } catch (const ros::Exception& error) {  // of the bag or of a message in it
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace falko_slam
