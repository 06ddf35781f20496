// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/bag_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace falko_slam {

BagFile::BagFile(std::string path, bool replace)
    : path_(std::move(path)), temporary_(path_ + "." + std::to_string(::getpid()) + ".part") {
  if (!replace && std::ifstream(path_)) {
    throw std::runtime_error(path_ + ": exists already");
  }
  try {
    bag_.open(temporary_, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path_ + ": cannot be written: " + error.what());
  }
}

BagFile::~BagFile() {
  if (finished_) return;
  bag_.close();
  std::remove(temporary_.c_str());
}

ros::Time BagFile::next_time(Time time) {
  const ros::Time wanted = to_ros(time);
  if (wanted < last_) {
    ++moved_times_;
  } else {
    last_ = wanted;
  }
  return last_;
}

void BagFile::finish() {
  bag_.close();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
  }
  finished_ = true;
}

}  // namespace falko_slam
