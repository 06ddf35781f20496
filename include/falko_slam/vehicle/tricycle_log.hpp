// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/vehicle/encoder_reading.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// What the log's header says of the vehicle: nominal values, the log's names in quotes.
struct TricycleLogHeader {
  std::string kinematic_model;
  double steer_gain = 1.0;     ///< "Ksteer": turn of the wheel per turn of its encoder
  double traction_gain = 0.0;  ///< "Ktraction": way of the driven wheel per turn of its encoder [m]
  double axis_length = 0.0;    ///< rear axle to driven wheel [m]
  double steer_offset = 0.0;   ///< added to the measured steering, in either direction [rad]
  std::uint32_t steer_ticks_per_turn = 0;     ///< "joints_max_enc_values" of "steering"
  std::uint32_t traction_ticks_per_turn = 0;  ///< the same of "traction_wheel"
  Pose2 base_T_laser;                         ///< "laser wrt base_link", in the plane
};

/// The header in our terms. They throw std::invalid_argument if it does not describe a vehicle.
TricycleParams tricycle_params_of(const TricycleLogHeader& header);
EncoderParams encoder_params_of(const TricycleLogHeader& header);

/// A "time:" line.
struct TricycleRecord {
  EncoderReading encoders;  ///< as recorded: the steering encoder wraps, the other one overflows
  Pose2 odom_T_base;        ///< "model_pose": odometry of the recording vehicle, nominal values
  Pose2 start_T_laser;      ///< "tracker_pose": the truth; pose of the laser in its first frame
};

/// What a reader has met so far.
struct TricycleLogReport {
  std::size_t lines = 0;
  std::size_t records = 0;
  std::size_t other = 0;                     ///< header, comments, blank lines
  std::size_t backward_stamps = 0;           ///< records earlier than the one before
  std::vector<std::size_t> malformed_lines;  ///< numbers of the lines that were left out, from 1
};

/// Reads the text log of a front-traction tricycle (plain, .gz or .bz2 by its ending) in the order
/// of the file: a header of lines that begin with #, then
///
///     time: T ticks: STEERING TRACTION model_pose: X Y THETA tracker_pose: X Y THETA
///
/// Throws std::runtime_error with the file's name if it cannot be opened or unpacked, or if the
/// header is not whole.
class TricycleLogReader {
 public:
  explicit TricycleLogReader(const std::string& path);
  ~TricycleLogReader();
  TricycleLogReader(TricycleLogReader&&) noexcept;
  TricycleLogReader& operator=(TricycleLogReader&&) noexcept;

  const TricycleLogHeader& header() const;

  /// Empty at the end of the file. Lines that are no comments, and are cut short or hold no numbers
  /// where these belong, are left out and listed in the report.
  std::optional<TricycleRecord> next();

  const TricycleLogReport& report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One line for a log: what was read, what was left out.
std::string describe(const TricycleLogReport& report);

}  // namespace falko_slam
