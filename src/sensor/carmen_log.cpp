// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/carmen_log.hpp"

#include <cmath>
#include <sstream>

#include "carmen_line.hpp"
#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/log_trouble.hpp"

namespace falko_slam {
namespace {

// The LMS of these logs reports 81.83 or 81.91 m where nothing returned.
constexpr double kDefaultMaxRange = 80.0;

const char* skip_word(const std::string& line, const char* word) {
  const std::size_t length = std::char_traits<char>::length(word);
  const bool matches = line.compare(0, length, word) == 0 && line.size() > length &&
                       (line[length] == ' ' || line[length] == '\t');
  return matches ? line.c_str() + length : nullptr;
}

}  // namespace

RawScan CarmenScan::raw() const {
  RawScan raw;
  raw.stamp = stamp;
  raw.angle_min = angle_min;
  raw.angle_increment = angle_increment;
  const auto beams = static_cast<double>(ranges.size());
  raw.angle_max = angle_min + (beams - 1.0) * angle_increment;
  // In these files a reading of range_max itself already means that nothing returned.
  raw.range_max = std::nextafter(static_cast<float>(range_max), 0.0F);
  raw.ranges = ranges.data();
  raw.range_count = ranges.size();
  return raw;
}

struct CarmenLogReader::State {
  explicit State(const std::string& path) : file(path) {}

  LineReader file;
  CarmenReport report;
  double flaser_range_max = kDefaultMaxRange;
  std::optional<Time> last_stamp;

  std::optional<CarmenRecord> parse(const std::string& line);
  template <class Record>
  std::optional<CarmenRecord> count(std::optional<Record> record, std::size_t& counter);
  void note(const CarmenVertex&) {}
  template <class Stamped>
  void note(const Stamped& record) {
    if (last_stamp && record.stamp < *last_stamp) ++report.backward_stamps;
    last_stamp = record.stamp;
  }
};

template <class Record>
std::optional<CarmenRecord> CarmenLogReader::State::count(std::optional<Record> record,
                                                          std::size_t& counter) {
  if (!record) {
    report.malformed_lines.push_back(report.lines);
    return std::nullopt;
  }
  ++counter;
  note(*record);
  return std::move(*record);
}

std::optional<CarmenRecord> CarmenLogReader::State::parse(const std::string& line) {
  if (const char* text = skip_word(line, "FLASER")) {
    return count(parse_flaser(text, flaser_range_max), report.scans);
  }
  if (const char* text = skip_word(line, "ROBOTLASER1")) {
    return count(parse_robotlaser(text), report.scans);
  }
  if (const char* text = skip_word(line, "ODOM")) return count(parse_odom(text), report.odometry);
  if (const char* text = skip_word(line, "VERTEX2")) {
    return count(parse_vertex(text), report.vertices);
  }
  ++report.other;
  if (const char* text = skip_word(line, "PARAM")) {
    const auto limit = parse_param(text, "robot_front_laser_max");
    if (limit && *limit > 0.0) flaser_range_max = *limit;
  }
  return std::nullopt;
}

CarmenLogReader::CarmenLogReader(const std::string& path) : state_(std::make_unique<State>(path)) {}
CarmenLogReader::~CarmenLogReader() = default;
CarmenLogReader::CarmenLogReader(CarmenLogReader&&) noexcept = default;
CarmenLogReader& CarmenLogReader::operator=(CarmenLogReader&&) noexcept = default;

std::optional<CarmenRecord> CarmenLogReader::next() {
  std::string line;
  while (state_->file.next(line)) {
    ++state_->report.lines;
    if (auto record = state_->parse(line)) return record;
  }
  return std::nullopt;
}

const CarmenReport& CarmenLogReader::report() const { return state_->report; }

std::string describe(const CarmenReport& report) {
  std::ostringstream text;
  text << report.lines << " lines: " << report.scans << " scans, " << report.odometry
       << " odometry readings, " << report.vertices << " corrected poses, " << report.other
       << " others" << describe_trouble(report.backward_stamps, report.malformed_lines);
  return text.str();
}

}  // namespace falko_slam
