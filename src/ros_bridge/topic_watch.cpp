// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/topic_watch.hpp"

#include <XmlRpcValue.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "falko_slam/common/number_text.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kMostSuggestions = 3;

std::string last_name(const std::string& topic) { return topic.substr(topic.rfind('/') + 1); }

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> others_of_type(const HeardTopic& topic, const TopicDirectory& directory) {
  std::vector<std::string> names;
  for (const auto& [name, published] : directory) {
    if (name != topic.name && published.type == topic.type) names.push_back(name);
  }
  std::stable_partition(names.begin(), names.end(), [&](const std::string& name) {
    return last_name(name) == last_name(topic.name);
  });
  if (names.size() > kMostSuggestions) names.resize(kMostSuggestions);
  return names;
}

std::string suggestion(const HeardTopic& topic, const TopicDirectory& directory) {
  const std::vector<std::string> names = others_of_type(topic, directory);
  if (names.empty()) return "";
  return " (did you mean " + list(names) + ", of this type?)";
}

}  // namespace

std::optional<TopicDirectory> ask_master() {
  TopicDirectory directory;
  XmlRpc::XmlRpcValue name, answer, state;
  name[0] = ros::this_node::getName();
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return {};
  if (!ros::master::execute("getSystemState", name, answer, state, false)) return {};
  // [[topic, [publisher, ...]], ...], and the same of subscribers and services. Only structures
  // have iterators.
  XmlRpc::XmlRpcValue& published = state[0];
  for (int i = 0; i < published.size(); ++i) {  // NOLINT(modernize-loop-convert)
    XmlRpc::XmlRpcValue& nodes = published[i][1];
    PublishedTopic& topic = directory[static_cast<std::string&>(published[i][0])];
    for (int k = 0; k < nodes.size(); ++k) {  // NOLINT(modernize-loop-convert)
      topic.publishers.push_back(nodes[k]);
    }
  }
  for (const ros::master::TopicInfo& topic : topics) directory[topic.name].type = topic.datatype;
  return directory;
}

SilenceCause silence_cause(const HeardTopic& topic, const TopicDirectory& directory) {
  const auto found = directory.find(topic.name);
  if (found == directory.end()) return SilenceCause::kNoPublisher;
  const std::string& type = found->second.type;
  return type == topic.type || type == "*" ? SilenceCause::kNoMessage : SilenceCause::kWrongType;
}

std::string describe_silence(const HeardTopic& topic, const TopicDirectory& directory) {
  const SilenceCause cause = silence_cause(topic, directory);
  if (cause == SilenceCause::kNoPublisher) {
    return "nobody publishes it" + suggestion(topic, directory);
  }
  const PublishedTopic& published = directory.at(topic.name);
  const std::string nodes = list(published.publishers);
  if (cause == SilenceCause::kNoMessage) return nodes + " should publish it, but is silent";
  return nodes + " publishes it with type " + published.type + ", expected " + topic.type +
         suggestion(topic, directory);
}

TopicWatch::TopicWatch(HeardTopic topic, double now, double timeout, AskMaster ask)
    : topic_(std::move(topic)), timeout_(timeout), ask_(std::move(ask)), last_(now) {}

void TopicWatch::heard(double now) {
  last_ = now;
  answer_.reset();
  outdated_ = question_.valid();
  if (told_) ROS_INFO_STREAM("messages come on " << topic_.name);
  told_ = false;
}

void TopicWatch::ask() {
  if (question_.valid()) {
    if (question_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    std::optional<TopicDirectory> answer = question_.get();
    if (!outdated_) answer_ = std::move(answer);
  }
  outdated_ = false;
  question_ = std::async(std::launch::async, ask_);
}

void TopicWatch::tell(double seconds) {
  if (told_ || !to_console_ || !answer_ || cause() == SilenceCause::kNoMessage) return;
  ROS_WARN_STREAM(describe(seconds));
  told_ = true;
}

std::string TopicWatch::trouble(double now) {
  const double seconds = silence(now);
  // A little early, so that the answer is there when it is needed.
  if (seconds > 0.5 * timeout_) ask();
  if (seconds > kPatience) tell(seconds);
  return seconds > timeout_ ? describe(seconds) : "";
}

std::string TopicWatch::describe(double seconds) const {
  return "no message on " + topic_.name + " for " + fixed_text(seconds, 1) + " s" +
         (answer_ ? ": " + describe_silence(topic_, *answer_) : "");
}

std::optional<SilenceCause> TopicWatch::cause() const {
  if (!answer_) return {};
  return silence_cause(topic_, *answer_);
}

}  // namespace falko_slam
