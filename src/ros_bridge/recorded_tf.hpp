// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>
#include <tf2/buffer_core.h>

#include <string>

namespace falko_slam {

/// All of a bag's tf, for the whole of its time.
class RecordedTf {
 public:
  explicit RecordedTf(const rosbag::Bag& bag);

  const tf2::BufferCore& buffer() const { return buffer_; }

 private:
  void read(const rosbag::Bag& bag, const std::string& topic);

  tf2::BufferCore buffer_;
};

}  // namespace falko_slam
