// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>

#include <functional>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace falko_slam {

/// A topic that a node hears, by its name in the graph.
struct HeardTopic {
  std::string name;  ///< resolved and remapped
  std::string type;  ///< sensor_msgs/LaserScan
};

template <class Message>
HeardTopic heard_topic(const std::string& name) {
  return {name, ros::message_traits::datatype<Message>()};
}

/// A topic that somebody has told the master to publish.
struct PublishedTopic {
  std::string type;
  std::vector<std::string> publishers;  ///< names of nodes; some may have died
};
using TopicDirectory = std::map<std::string, PublishedTopic>;

/// All published topics; nothing if the master does not answer. Waits for it.
std::optional<TopicDirectory> ask_master();

/// Why nothing comes on a topic.
enum class SilenceCause {
  kNoPublisher,
  kWrongType,  ///< roscpp refuses such publishers without a word to the user
  kNoMessage,  ///< there are publishers of the right type
};
SilenceCause silence_cause(const HeardTopic& topic, const TopicDirectory& directory);
/// The same in words, with the topics that may be meant instead: those with the right type, first
/// those whose last names are alike.
std::string describe_silence(const HeardTopic& topic, const TopicDirectory& directory);

/// Whether messages come on a topic, and if not, why, for /diagnostics. A topic that nobody
/// publishes, or publishes with another type, is told to the console, too, once for each silence:
/// most likely its name is misspelt.
///
/// The master is asked by a thread of its own, and only while something is missing: nobody waits
/// for it. With a report every second a topic is named within `timeout` and one second of the last
/// message, and the cause half a `timeout` and two seconds after it at the latest. Times are those
/// of the steady clock [s]. Not for several threads.
class TopicWatch {
 public:
  using AskMaster = std::function<std::optional<TopicDirectory>()>;
  /// So that a missing topic is named, and with the cause, within three seconds.
  static constexpr double kTimeout = 1.5;
  /// A silence that goes to the console [s]: longer than it takes all nodes to start.
  static constexpr double kPatience = 5.0;

  TopicWatch(HeardTopic topic, double now, double timeout = kTimeout, AskMaster ask = ask_master);

  void heard(double now);
  double silence(double now) const { return now - last_; }
  const std::string& name() const { return topic_.name; }

  /// "" while messages come. To be called now and then.
  std::string trouble(double now);
  /// What is to be told of a silence of so many seconds.
  std::string describe(double seconds) const;
  /// Nothing as long as the master has not been asked or messages come.
  std::optional<SilenceCause> cause() const;
  /// For a topic that may well be silent: the console is told nothing.
  void keep_from_console() { to_console_ = false; }
  /// The console knows of the silence.
  bool told() const { return told_; }

 private:
  void ask();
  void tell(double seconds);

  HeardTopic topic_;
  double timeout_;
  AskMaster ask_;
  double last_;  // message, or the beginning
  std::future<std::optional<TopicDirectory>> question_;
  bool outdated_ = false;  // messages came after the question
  std::optional<TopicDirectory> answer_;
  bool to_console_ = true;
  bool told_ = false;
};

}  // namespace falko_slam
