// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "falko_slam/common/time.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

/// What the encoders say of an instant.
struct EncoderInstant {
  Time stamp{};
  Pose2 odom_T_laser;
  std::int64_t ticks = 0;  ///< of the driven wheel since the first reading
  double steering = 0.0;   ///< [rad], not wrapped
  bool moving = false;     ///< the counter changed since the one before
};

/// The last seconds of the laser's odometry.
class EncoderTrack {
 public:
  EncoderTrack(const TricycleParams& tricycle, const EncoderParams& encoders,
               const Pose2& base_T_laser);

  /// False, and nothing has changed, for a reading that is not later than the last one.
  bool add(const EncoderReading& reading);

  bool empty() const { return instants_.empty(); }
  const EncoderInstant& last() const { return instants_.back(); }
  /// The one before the last.
  const EncoderInstant& before_last() const { return instants_[instants_.size() - 2]; }
  bool first() const { return instants_.size() == 1; }

  /// Evenly between the readings; none before the first that is remembered and after the last.
  std::optional<EncoderInstant> at(Time time) const;

 private:
  EncoderParams encoders_;
  Pose2 base_T_laser_;
  TricycleOdometry odometry_;
  std::deque<EncoderInstant> instants_;
};

}  // namespace falko_slam
