// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace falko_slam {
namespace test {

/// A message as it lies in a bag: topic, type, time of playing, serialised.
struct BagMessage {
  std::string topic, type;
  ros::Time time;
  std::vector<std::uint8_t> bytes;

  bool operator==(const BagMessage& other) const {
    return std::tie(topic, type, time, bytes) ==
           std::tie(other.topic, other.type, other.time, other.bytes);
  }
};

/// All messages in the order in which they play.
inline std::vector<BagMessage> bag_messages(const std::string& path) {
  rosbag::Bag bag(path);
  rosbag::View view(bag);
  std::vector<BagMessage> messages;
  for (const rosbag::MessageInstance& instance : view) {
    BagMessage message{instance.getTopic(), instance.getDataType(), instance.getTime(), {}};
    message.bytes.resize(instance.size());
    ros::serialization::OStream stream(message.bytes.data(), instance.size());
    instance.write(stream);
    messages.push_back(message);
  }
  return messages;
}

/// The messages of one topic.
template <class Message>
std::vector<Message> bag_messages_on(const std::string& path, const std::string& topic) {
  rosbag::Bag bag(path);
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  std::vector<Message> messages;
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = instance.instantiate<Message>();
    if (message) messages.push_back(*message);
  }
  return messages;
}

inline std::vector<std::string> topics_in_order(const std::vector<BagMessage>& messages) {
  std::vector<std::string> topics;
  for (const BagMessage& message : messages) topics.push_back(message.topic);
  return topics;
}

}  // namespace test
}  // namespace falko_slam
