// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <string>

#include "falko_slam/common/time.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {

/// Writes a bag beside its final name and moves it there when finished: an old file is replaced by
/// a whole new one or not at all.
class BagFile {
 public:
  /// Throws std::runtime_error with the name if the file cannot be written, or exists already and
  /// may not be replaced.
  BagFile(std::string path, bool replace);
  /// Removes what was not finished.
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// Bags are read in the order of their times, and messages of one time in any order: a message
  /// that is not later than the one before it is moved to the nanosecond after that. Topics are
  /// written with their whole names, as recorders do.
  template <class Message>
  void write(const std::string& topic, Time time, const Message& message) {
    report_failure([&] { bag_->write("/" + topic, next_time(time), message); });
  }
  /// For messages of all times, such as static transforms.
  template <class Message>
  void write_latched(const std::string& topic, Time time, const Message& message) {
    namespace traits = ros::message_traits;
    const auto header = boost::make_shared<ros::M_string>();
    (*header)["type"] = traits::datatype(message);
    (*header)["md5sum"] = traits::md5sum(message);
    (*header)["message_definition"] = traits::definition(message);
    (*header)["latching"] = "1";
    report_failure([&] { bag_->write("/" + topic, next_time(time), message, header); });
  }

  /// Throws std::runtime_error with the name, as writing does, if there is no more space.
  void finish();

  /// Messages earlier than one before them.
  std::size_t moved_times() const { return moved_times_; }
  /// Says so in words that follow others; empty if there are none.
  std::string describe_moved_times() const;

 private:
  template <class Work>
  void report_failure(Work&& work) {
    try {
      work();
    } catch (const rosbag::BagException& error) {
      fail(error.what());
    }
  }
  [[noreturn]] void fail(const std::string& reason) const;
  void close();
  ros::Time next_time(Time time);

  std::string path_;
  std::string temporary_;
  std::unique_ptr<rosbag::Bag> bag_;
  ros::Time latest_ = ros::TIME_MIN;  // asked for
  ros::Time last_;                    // written
  std::size_t moved_times_ = 0;
  bool finished_ = false;
};

}  // namespace falko_slam
