// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/log_kind.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "falko_slam/common/line_reader.hpp"

namespace falko_slam {
namespace {

constexpr std::array<const char*, 5> kCarmenWords = {"FLASER", "ROBOTLASER1", "ODOM", "VERTEX2",
                                                     "PARAM"};
constexpr std::array<const char*, 2> kTricycleWords = {"time:", "#kinematic_model:"};

template <class Words>
bool starts_with_one(const std::string& line, const Words& words) {
  const std::string first = line.substr(0, line.find_first_of(" \t\r"));
  return std::find(words.begin(), words.end(), first) != words.end();
}

}  // namespace

LogKind recognize_log(const std::string& path) {
  LineReader file(path);
  for (std::string line; file.next(line);) {
    if (starts_with_one(line, kCarmenWords)) return LogKind::kCarmen;
    if (starts_with_one(line, kTricycleWords)) return LogKind::kTricycle;
  }
  throw std::runtime_error(path + ": neither a CARMEN log nor a tricycle's log: none of " +
                           std::to_string(file.lines()) + " lines begins as theirs do");
}

}  // namespace falko_slam
