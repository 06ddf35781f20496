// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle_log.hpp"

#include <sstream>
#include <stdexcept>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/log_trouble.hpp"
#include "tricycle_line.hpp"

namespace falko_slam {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

TricycleParams tricycle_params_of(const TricycleLogHeader& header) {
  TricycleParams params;
  params.wheelbase = header.axis_length;
  params.driving_scale = header.traction_gain / header.traction_ticks_per_turn;
  params.steer_offset_forward = header.steer_offset;
  params.steer_offset_backward = header.steer_offset;
  validate(params);
  return params;
}

EncoderParams encoder_params_of(const TricycleLogHeader& header) {
  EncoderParams params;
  params.steer_ticks_per_turn = header.steer_ticks_per_turn;
  params.steer_gain = header.steer_gain;
  validate(params);
  return params;
}

struct TricycleLogReader::State {
  explicit State(const std::string& path) : file(path) {}

  LineReader file;
  TricycleLogHeader header;
  TricycleLogReport report;
  std::optional<std::string> ahead;  // the line that ended the header
  std::optional<Time> last_stamp;

  bool next_line(std::string& line);
  void read_header(const std::string& path);
  std::optional<TricycleRecord> parse(const std::string& line);
};

bool TricycleLogReader::State::next_line(std::string& line) {
  if (ahead) {
    line = *ahead;
    ahead.reset();
  } else if (!file.next(line)) {
    return false;
  }
  ++report.lines;
  return true;
}

void TricycleLogReader::State::read_header(const std::string& path) {
  TricycleHeaderParser parser;
  std::string line;
  while (file.next(line)) {
    if (!is_blank(line) && line.front() != '#') {
      ahead = line;
      break;
    }
    if (!is_blank(line)) parser.add(line);
    ++report.lines;
    ++report.other;
  }
  try {
    header = parser.header();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": no tricycle log: " + error.what());
  }
}

std::optional<TricycleRecord> TricycleLogReader::State::parse(const std::string& line) {
  if (is_blank(line) || line.front() == '#') {
    ++report.other;
    return std::nullopt;
  }
  auto record = parse_tricycle_record(line);
  if (!record) {
    report.malformed_lines.push_back(report.lines);
    return std::nullopt;
  }
  ++report.records;
  if (last_stamp && record->encoders.stamp < *last_stamp) ++report.backward_stamps;
  last_stamp = record->encoders.stamp;
  return record;
}

TricycleLogReader::TricycleLogReader(const std::string& path)
    : state_(std::make_unique<State>(path)) {
  state_->read_header(path);
}
TricycleLogReader::~TricycleLogReader() = default;
TricycleLogReader::TricycleLogReader(TricycleLogReader&&) noexcept = default;
TricycleLogReader& TricycleLogReader::operator=(TricycleLogReader&&) noexcept = default;

const TricycleLogHeader& TricycleLogReader::header() const { return state_->header; }

std::optional<TricycleRecord> TricycleLogReader::next() {
  std::string line;
  while (state_->next_line(line)) {
    if (auto record = state_->parse(line)) return record;
  }
  return std::nullopt;
}

const TricycleLogReport& TricycleLogReader::report() const { return state_->report; }

std::string describe(const TricycleLogReport& report) {
  std::ostringstream text;
  text << report.lines << " lines: " << report.records << " encoder readings with poses, "
       << report.other << " others"
       << describe_trouble(report.backward_stamps, report.malformed_lines);
  return text.str();
}

}  // namespace falko_slam
