// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/reflector_motion_estimator.hpp"
#include "falko_slam/common/time.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

/// A reflector that a scan found, as the laser saw it from where it was then.
struct SightedReflector {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< in the frame of the laser at its time [m]
  Duration after_first_beam{};
};

/// The reflectors that a scan found.
struct ReflectorObservation {
  Time first_beam{};
  std::vector<SightedReflector> reflectors;
};

struct SegmentRecorderParams {
  TricycleParams tricycle;  ///< as it is believed to be: only leads from scan to scan
  Pose2 base_T_laser;       ///< the same
  EncoderParams encoders;
  ReflectorMotionParams reflectors;
  double scan_duration = 0.125;  ///< from the first beam to the last [s], [0, 10]
  double settling = 0.3;         ///< after a halt, until scans count as taken at rest [s], [0, 60]
  std::size_t min_scans_at_rest = 2;  ///< at each end of a segment, [1, 10000]
  double min_way = 0.2;               ///< of the wheel; less is no segment [m], [0, 1000]
  double max_steering_change = 0.01;  ///< while it drives; more is no arc [rad], [0, pi]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SegmentRecorderParams& params);

/// A drive from halt to halt.
struct RecordedSegment {
  Time begin{}, end{};         ///< of the motion, by the encoders
  PathSegment segment;         ///< only if there is no complaint
  ReflectorMotion motion;      ///< the same
  std::string complaint;       ///< why it is no segment
  std::size_t lost_scans = 0;  ///< on the way, that fitted nowhere
};

/// Cuts a drive into path segments, from the encoders and the reflectors as they come, online or
/// from a recording alike. A segment lasts from one halt of the driven wheel to the next; the scans
/// of a halt between two segments go to one half each, so that what errs in them errs in one
/// segment only. Readings and observations must come in the order of their times, each kind for
/// itself. Not thread-safe.
class SegmentRecorder {
 public:
  explicit SegmentRecorder(const SegmentRecorderParams& params);

  /// Readings that are not later than the last one are left out.
  void add(const EncoderReading& reading);
  /// Waits for the encoders of its time.
  void add(const ReflectorObservation& observation);
  /// The drive is over: the last segment ends with the halt that it is in.
  void finish();

  /// What has been completed since the last call: a segment is complete when the next one begins.
  std::vector<RecordedSegment> take();

  bool at_rest() const { return !way_ || way_->halted; }
  /// Scans at rest since the last halt.
  std::size_t scans_at_rest() const { return halt_.size(); }

 private:
  struct Sight {
    ReflectorPoints points;
    Pose2 odom_T_laser;
  };
  struct Way {
    Time begin{}, end{};
    std::int64_t ticks = 0;
    double steering_sum = 0.0;  // weighted by ticks
    double least_steering = 0.0, greatest_steering = 0.0;
    std::vector<Sight> start, sights;
    bool halted = false;
  };

  struct Instant {
    Time stamp{};
    Pose2 odom_T_laser;
    std::int64_t ticks = 0;
    double steering = 0.0;
    bool moving = false;  // the counter changed since the one before
  };

  void use_waiting();
  void use(const ReflectorObservation& observation);
  ReflectorPoints seen_at_first_beam(const ReflectorObservation& observation,
                                     const Instant& first) const;
  std::optional<Instant> at(Time time) const;
  void begin_way(const Instant& from);
  void extend_way(const Instant& from, const Instant& to);
  void complete_way(const std::vector<Sight>& end);
  RecordedSegment evaluate(const Way& way, const std::vector<Sight>& end) const;

  SegmentRecorderParams params_;
  TricycleOdometry odometry_;
  std::deque<Instant> instants_;  // of the last scans' time
  std::deque<ReflectorObservation> waiting_;
  std::optional<Way> way_;   // the last one, or the one that is being driven
  std::vector<Sight> halt_;  // since the last halt
  Time halted_since_{};
  std::vector<RecordedSegment> done_;
};

}  // namespace falko_slam
