// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "falko_slam/calibration/recorded_segment.hpp"
#include "falko_slam/calibration/reflector_motion_estimator.hpp"
#include "falko_slam/calibration/scan_motion_estimator.hpp"
#include "falko_slam/common/time.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
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

/// A scan as it was taken; it brings its own times.
struct ScanObservation {
  LaserScan scan;
};

struct SegmentRecorderParams {
  TricycleParams tricycle;  ///< as it is believed to be: only leads from scan to scan
  Pose2 base_T_laser;       ///< the same
  EncoderParams encoders;
  /// Observations of the other kind are left out.
  EgomotionSource egomotion = EgomotionSource::kReflectors;
  ReflectorMotionParams reflectors;
  ScanMotionParams scans;
  double scan_duration = 0.125;  ///< from the first beam to the last [s], [0, 10]
  double settling = 0.3;         ///< after a halt, until scans count as taken at rest [s], [0, 60]
  std::size_t min_scans_at_rest = 2;  ///< at each end of a segment, [1, 10000]
  double min_way = 0.2;               ///< of the wheel; less is no segment [m], [0, 1000]
  double max_steering_change = 0.01;  ///< while it drives; more is no arc [rad], [0, pi]
  /// Of a halt; of a longer one those in its middle are forgotten. [2, 100000]
  std::size_t max_scans_at_rest = 400;
  /// Of a way; a longer one is no segment, and its scans are forgotten. [1, 1000000]
  std::size_t max_scans_on_the_way = 1600;
  /// That wait for the encoders; if more do, the oldest is lost, and with it the segment. [1,
  /// 10000]
  std::size_t max_waiting_scans = 200;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SegmentRecorderParams& params);

/// Cuts a drive into path segments, from the encoders and what the laser saw as they come, online
/// or from a recording alike. A segment lasts from one halt of the driven wheel to the next; the
/// scans of a halt between two segments go to one half each, so that what errs in them errs in one
/// segment only. Readings and observations must come in the order of their times, each kind for
/// itself. What is kept is bounded by the params, however long a vehicle stands, drives or keeps
/// its encoders to itself. Not thread-safe.
class SegmentRecorder {
 public:
  explicit SegmentRecorder(const SegmentRecorderParams& params);
  ~SegmentRecorder();
  SegmentRecorder(SegmentRecorder&&) noexcept;
  SegmentRecorder& operator=(SegmentRecorder&&) noexcept;

  /// Readings that are not later than the last one are left out.
  void add(const EncoderReading& reading);
  /// Waits for the encoders of its time.
  void add(const ReflectorObservation& observation);
  void add(const ScanObservation& observation);
  /// The drive is over: the last segment ends with the halt that it is in.
  void finish();

  /// What has been completed since the last call: a segment is complete when the next one begins.
  std::vector<RecordedSegment> take();

  bool at_rest() const;
  /// Scans at rest since the last halt, as many as are kept.
  std::size_t scans_at_rest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace falko_slam
