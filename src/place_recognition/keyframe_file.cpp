// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_file.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "falko_slam/common/sealed_bytes.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/pose_bytes.hpp"

namespace falko_slam {
namespace {

const FileKind kKeyframes{"FALKOKEY", 1, "keyframes"};
// Of a record without beams. A count is compared with what is left before memory is asked for.
constexpr std::size_t kLeastRecord = 4 * 8 + 9 * 8 + 2 + 4;
constexpr double kFarthest = 1e6;   // [m]
constexpr double kWidest = 1000.0;  // more than what normalize() lets pass [rad]
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void put(ByteWriter& out, const LaserScan& scan) {
  out.i64(scan.first_beam_time.time_since_epoch().count());
  out.i64(scan.time_increment.count());
  out.f64(scan.angle_min);
  out.f64(scan.angle_increment);
  out.f64(scan.range_max);
  out.u8(scan.closed ? 1 : 0);
  out.u8(scan.reversed ? 1 : 0);
  out.u32(static_cast<std::uint32_t>(scan.size()));
  for (std::size_t i = 0; i < scan.size(); ++i) {
    out.u8(static_cast<std::uint8_t>(scan.status[i]));
    if (scan.valid(i)) out.f32(static_cast<float>(scan.ranges[i]));
  }
}

double number_in(double value, double limit, const char* name) {
  require_sound(std::abs(value) <= limit,
                std::string(name) + " " + std::to_string(value) + " makes no sense");
  return value;
}

bool flag(ByteReader& in, const char* name) {
  const std::uint8_t value = in.u8();
  require_sound(value <= 1, std::string(name) + " is neither true nor false");
  return value == 1;
}

void take_beam(ByteReader& in, std::size_t beam, LaserScan& scan) {
  const std::uint8_t status = in.u8();
  require_sound(status < kBeamStatusCount, "beam " + std::to_string(beam) + " has status " +
                                               std::to_string(status) + ", which is not known");
  scan.status.push_back(static_cast<BeamStatus>(status));
  scan.ranges.push_back(kNaN);
  if (!scan.valid(beam)) return;
  const auto range = static_cast<double>(in.f32());
  require_sound(range >= 0.0 && range <= kFarthest, "beam " + std::to_string(beam) + " has range " +
                                                        std::to_string(range) +
                                                        ", which makes no sense");
  scan.ranges.back() = range;
}

LaserScan take_scan(ByteReader& in) {
  LaserScan scan;
  scan.first_beam_time = Time(Duration(in.i64()));
  scan.time_increment = Duration(in.i64());
  scan.angle_min = number_in(in.f64(), kWidest, "angle_min");
  scan.angle_increment = number_in(in.f64(), kWidest, "angle_increment");
  scan.range_max = number_in(in.f64(), kFarthest, "range_max");
  scan.closed = flag(in, "closed");
  scan.reversed = flag(in, "reversed");
  const std::uint32_t beams = in.u32();
  require_sound(beams <= in.left(), "ends too early");
  require_sound(scan.angle_increment > 0.0 || (scan.angle_increment == 0.0 && beams <= 1),
                "angle_increment " + std::to_string(scan.angle_increment) + " makes no sense");
  require_sound(beams * scan.angle_increment < kTwoPi + 1.5 * scan.angle_increment,
                "its beams are more than a full turn");
  scan.status.reserve(beams);
  scan.ranges.reserve(beams);
  for (std::uint32_t beam = 0; beam < beams; ++beam) take_beam(in, beam, scan);
  return scan;
}

KeyframeRecord take_record(ByteReader& in, const std::vector<KeyframeRecord>& before) {
  KeyframeRecord record;
  record.stamp = Time(Duration(in.i64()));
  const std::uint64_t drive = in.u64();
  if (before.empty()) {
    require_sound(drive == 0, "drive " + std::to_string(drive) + " is not the first one");
  } else {
    const std::size_t last = before.back().drive;
    require_sound(
        drive == last || drive == last + 1,
        "drive " + std::to_string(drive) + " does not follow drive " + std::to_string(last));
  }
  record.drive = drive;
  record.odom_T_laser = take_pose(in);
  record.base_T_laser = take_pose(in);
  record.scan = take_scan(in);
  return record;
}

}  // namespace

std::string to_bytes(const std::vector<KeyframeRecord>& records) {
  ByteWriter out = begin_sealed(kKeyframes);
  out.u64(records.size());
  for (const KeyframeRecord& record : records) {
    out.i64(record.stamp.time_since_epoch().count());
    out.u64(record.drive);
    put(out, record.odom_T_laser);
    put(out, record.base_T_laser);
    put(out, record.scan);
  }
  return seal(std::move(out));
}

std::vector<KeyframeRecord> keyframes_from(const std::string& bytes) {
  ByteReader in = open_sealed(bytes, kKeyframes);
  const std::uint64_t count = in.u64();
  require_sound(count <= in.left() / kLeastRecord, "ends too early");
  std::vector<KeyframeRecord> records;
  records.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    try {
      records.push_back(take_record(in, records));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("keyframe " + std::to_string(i) + ": " + error.what());
    }
  }
  require_end(in);
  return records;
}

void write_keyframe_file(const std::string& path, const std::vector<KeyframeRecord>& records) {
  if (records.empty()) throw std::runtime_error(path + ": there is no keyframe to save");
  const std::string bytes = to_bytes(records);
  try {
    keyframes_from(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": could not be read again, not written: " + error.what());
  }
  write_sealed_file(path, bytes, kKeyframes);
}

std::vector<KeyframeRecord> read_keyframe_file(const std::string& path) {
  const std::string bytes = read_whole_file(path);
  try {
    return keyframes_from(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace falko_slam
