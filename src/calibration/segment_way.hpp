// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "encoder_track.hpp"
#include "falko_slam/calibration/segment_recorder.hpp"

namespace falko_slam {

/// A scan and the laser's motion while it was taken.
struct SweptScan {
  LaserScan scan;
  LaserMotion sweep;
};

/// What was seen from where, by the encoders, when its first beam left. Reflectors are moved to
/// where they are seen from there.
struct Sight {
  std::variant<ReflectorPoints, SweptScan> seen;
  Pose2 odom_T_laser;
};

/// From a halt on: what was seen before it and on it, and what the encoders summed up.
struct Way {
  Time begin{}, end{};
  std::int64_t ticks = 0;
  double steering_sum = 0.0;  // weighted by ticks
  double least_steering = 0.0, greatest_steering = 0.0;
  std::vector<Sight> start, sights;
  bool halted = false;
  bool too_long = false;

  void extend(const EncoderInstant& from, const EncoderInstant& to);
};

/// The segment that ends with this halt, or why it is none.
RecordedSegment evaluate(const Way& way, const std::vector<Sight>& end,
                         const SegmentRecorderParams& params);

}  // namespace falko_slam
