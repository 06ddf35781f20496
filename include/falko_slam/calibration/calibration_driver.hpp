// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/calibration_plan.hpp"
#include "falko_slam/common/time.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"
#include "falko_slam/vehicle/wheel_command.hpp"

namespace falko_slam {

struct CalibrationDriverParams {
  TricycleParams tricycle;  ///< as it is believed to be
  EncoderParams encoders;
  double encoder_timeout = 0.3;       ///< readings older than this are lost [s], [0.01, 10]
  double scan_timeout = 1.0;          ///< the same of scans that show something [s], [0.01, 60]
  double steering_tolerance = 0.005;  ///< at which the wheel counts as steered [rad], [1e-5, 0.2]
  double motion_timeout = 5.0;        ///< steered, started or halted within this [s], [0.1, 60]
  double braking = 0.2;               ///< that the vehicle can surely do [m/s^2], [0.01, 10]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationDriverParams& params);

/// What the driver does at the moment.
enum class CalibrationStage { kResting, kSteering, kDriving, kHalting, kDone, kAborted };
const char* name_of(CalibrationStage stage);

/// How far it is.
struct CalibrationProgress {
  CalibrationStage stage = CalibrationStage::kResting;
  DrivePhase phase = DrivePhase::kForwardLeft;
  std::size_t arc = 0;    ///< the one that is driven, from 0
  std::size_t arcs = 0;   ///< in all
  double fraction = 0.0;  ///< of the whole calibration, [0, 1]
};

/// Drives the arcs of a plan, one control period after the other: rests, steers at rest, drives
/// until the encoders say that it has turned enough, halts. What goes wrong ends it: the command of
/// the very same period halts the vehicle, and every later one. Not thread-safe.
class CalibrationDriver {
 public:
  /// Throws std::invalid_argument if a plan or a parameter is none, or if even an ideal vehicle
  /// would leave the area.
  CalibrationDriver(const CalibrationPlan& plan, const CalibrationDriverParams& params);

  /// Ticks of the wheel since the reading before.
  std::int32_t add(const EncoderReading& reading);
  /// What was seen: reflectors or valid beams; scans that show nothing are none.
  void add_scan(Time stamp, std::size_t seen);

  /// The command for the period that begins now.
  WheelCommand next(Time now);

  /// Ends it; the reason is kept unless there is one already.
  void abort(const std::string& reason);

  bool done() const { return stage_ == CalibrationStage::kDone; }
  /// Empty unless it was aborted.
  const std::string& reason() const { return reason_; }
  CalibrationProgress progress() const;
  /// By the encoders, seen from where it started.
  const Pose2& start_T_base() const { return odometry_.odom_T_base(); }

 private:
  void watch(Time now);
  void enter(CalibrationStage stage, Time now);
  double remaining_way() const;
  void advance(Time now);

  CalibrationPlan plan_;
  CalibrationDriverParams params_;
  std::vector<PlannedArc> arcs_;
  TricycleOdometry odometry_;
  CalibrationStage stage_ = CalibrationStage::kResting;
  std::optional<Time> entered_, last_reading_, last_scan_, begin_;
  std::size_t arc_ = 0;
  double turned_ = 0.0;  // on this arc [rad]
  double steering_ = 0.0;
  std::int32_t last_ticks_ = 0;
  Time moved_{};
  std::string reason_;
};

}  // namespace falko_slam
