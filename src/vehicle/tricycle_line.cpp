// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tricycle_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "falko_slam/common/number_text.hpp"

namespace falko_slam {
namespace {

// Its nanoseconds still fit into 64 bits.
constexpr std::chrono::seconds kLatest(9'000'000'000);

std::vector<std::string> words_of(std::string line) {
  for (char& letter : line) {
    if (letter == '[' || letter == ']' || letter == ',') letter = ' ';
  }
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool only_digits(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

std::optional<std::uint32_t> counter_of(const std::string& text) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (!only_digits(text)) return std::nullopt;
  const auto value = number_of(text);
  if (!value || *value > kMost) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

// To the nanosecond: a double of seconds since 1970 is good for a quarter of a microsecond.
std::optional<Time> time_of(const std::string& text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string seconds = text.substr(0, point);
  std::string nanoseconds = point < text.size() ? text.substr(point + 1) : "0";
  if (!only_digits(seconds) || seconds.size() > 10 || !only_digits(nanoseconds)) {
    return std::nullopt;
  }
  nanoseconds.resize(9, '0');
  const auto whole = std::chrono::seconds(std::stoll(seconds));
  if (whole > kLatest) return std::nullopt;
  return Time(whole + std::chrono::nanoseconds(std::stoll(nanoseconds)));
}

std::optional<Pose2> pose_of(const std::vector<std::string>& words, std::size_t first) {
  const auto x = number_of(words[first]);
  const auto y = number_of(words[first + 1]);
  const auto theta = number_of(words[first + 2]);
  if (!x || !y || !theta) return std::nullopt;
  return Pose2(*x, *y, *theta);
}

}  // namespace

std::optional<TricycleRecord> parse_tricycle_record(const std::string& line) {
  const std::vector<std::string> words = words_of(line);
  if (words.size() != 13 || words[0] != "time:" || words[2] != "ticks:" ||
      words[5] != "model_pose:" || words[9] != "tracker_pose:") {
    return std::nullopt;
  }
  const auto stamp = time_of(words[1]);
  const auto steer_ticks = counter_of(words[3]);
  const auto drive_ticks = counter_of(words[4]);
  const auto odom_T_base = pose_of(words, 6);
  const auto start_T_laser = pose_of(words, 10);
  if (!stamp || !steer_ticks || !drive_ticks || !odom_T_base || !start_T_laser) return std::nullopt;
  return TricycleRecord{{*stamp, *drive_ticks, *steer_ticks}, *odom_T_base, *start_T_laser};
}

void TricycleHeaderParser::add(const std::string& comment) {
  std::vector<std::string> words = words_of(comment.substr(1));
  if (words.empty()) return;
  const std::string key = words.front();
  words.erase(words.begin());
  lines_.emplace(key, words);
}

const TricycleHeaderParser::Words& TricycleHeaderParser::line(const std::string& key) const {
  const auto found = lines_.find(key);
  if (found == lines_.end()) throw std::runtime_error("its header has no \"" + key + "\"");
  return found->second;
}

// Names stand in one line, their values in another.
double TricycleHeaderParser::value(const std::string& list, const std::string& name) const {
  const bool parameter = list == "parameters:";
  const Words& names = line(list);
  const Words& values = line(parameter ? "parameter_values:" : "joints_max_enc_values:");
  const auto index =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  const auto value =
      index < std::min(names.size(), values.size()) ? number_of(values[index]) : std::nullopt;
  if (!value) throw std::runtime_error("its header has no value of \"" + name + "\"");
  return *value;
}

std::uint32_t TricycleHeaderParser::ticks(const std::string& name) const {
  const double count = value("joints_max_enc:", name);
  if (!(count >= 1.0 && count <= 1e9) || count != std::floor(count)) {
    throw std::runtime_error("its header has no number of ticks of \"" + name + "\"");
  }
  return static_cast<std::uint32_t>(count);
}

std::vector<double> TricycleHeaderParser::numbers(const std::string& key, std::size_t count) const {
  std::vector<double> result;
  for (const std::string& word : line(key)) {
    if (const auto number = number_of(word)) result.push_back(*number);
  }
  if (result.size() != count || line(key).size() != count) {
    throw std::runtime_error("its header's \"" + key + "\" has not " + std::to_string(count) +
                             " numbers");
  }
  return result;
}

TricycleLogHeader TricycleHeaderParser::header() const {
  TricycleLogHeader header;
  const Words& model = line("kinematic_model:");
  header.kinematic_model = model.empty() ? "" : model.front();
  header.steer_gain = value("parameters:", "Ksteer");
  header.traction_gain = value("parameters:", "Ktraction");
  header.axis_length = value("parameters:", "axis_length");
  header.steer_offset = value("parameters:", "steer_offset");
  header.steer_ticks_per_turn = ticks("steering");
  header.traction_ticks_per_turn = ticks("traction_wheel");
  const std::vector<double> position = numbers("translation:", 3);
  const std::vector<double> q = numbers("rotation:", 4);  // x, y, z, w
  const double heading =
      std::atan2(2.0 * (q[0] * q[1] + q[3] * q[2]), 1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2]));
  header.base_T_laser = {position[0], position[1], heading};
  return header;
}

}  // namespace falko_slam
