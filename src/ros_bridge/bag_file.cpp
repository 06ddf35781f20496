// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/bag_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace falko_slam {

BagFile::BagFile(std::string path, bool replace)
    : path_(std::move(path)),
      temporary_(path_ + "." + std::to_string(::getpid()) + ".part"),
      bag_(std::make_unique<rosbag::Bag>()) {
  if (!replace && std::ifstream(path_)) {
    throw std::runtime_error(path_ + ": exists already");
  }
  report_failure([this] { bag_->open(temporary_, rosbag::bagmode::Write); });
}

BagFile::~BagFile() {
  if (finished_) return;
  try {
    close();
  } catch (const std::runtime_error&) {
    // Whoever wrote has been told, and the file goes anyway.
  }
  std::remove(temporary_.c_str());
}

void BagFile::fail(const std::string& reason) const {
  throw std::runtime_error(path_ + ": cannot be written: " + reason);
}

void BagFile::close() {
  if (!bag_) return;
  try {
    bag_->close();
    bag_.reset();
  } catch (const rosbag::BagException& error) {
    // Given up: its destructor would close it again, throw again and so end the program.
    static_cast<void>(bag_.release());
    fail(error.what());
  }
}

ros::Time BagFile::next_time(Time time) {
  const ros::Time wanted = to_ros(time);
  if (wanted < latest_) ++moved_times_;
  latest_ = std::max(latest_, wanted);
  const ros::Time next = last_ < ros::TIME_MAX ? last_ + ros::Duration(0, 1) : last_;
  last_ = std::max(wanted, next);
  return last_;
}

std::string BagFile::describe_moved_times() const {
  if (moved_times_ == 0) return "";
  return "; " + std::to_string(moved_times_) +
         " messages play later than their stamps say, so that the bag's time never runs back";
}

void BagFile::finish() {
  close();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(std::strerror(errno));
  finished_ = true;
}

}  // namespace falko_slam
