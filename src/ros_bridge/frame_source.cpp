// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/frame_source.hpp"

namespace falko_slam {
namespace {

// The text between the quotes that follow `key`, from a position on.
std::string quoted_after(const std::string& text, const std::string& key, std::size_t from) {
  const std::size_t found = text.find(key, from);
  if (found == std::string::npos) return "";
  const std::size_t begin = text.find('\'', found);
  const std::size_t end = begin == std::string::npos ? begin : text.find('\'', begin + 1);
  return end == std::string::npos ? "" : text.substr(begin + 1, end - begin - 1);
}

}  // namespace

std::optional<FrameSource> source_of(const tf2::BufferCore& buffer, const std::string& frame) {
  // tf2 tells it in no other way.
  const std::string all = "\n" + buffer.allFramesAsYAML();
  const std::size_t entry = all.find("\n" + frame + ": ");
  if (entry == std::string::npos) return std::nullopt;
  return FrameSource{quoted_after(all, "parent:", entry), quoted_after(all, "broadcaster:", entry)};
}

}  // namespace falko_slam
