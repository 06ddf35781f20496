// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "falko_slam/vehicle/encoder_reading.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

struct TricycleOdometryParams {
  /// Faster than this the driven wheel cannot be: a greater step of its counter is a jump, not a
  /// motion. 0: all steps are motion [m/s]
  double max_wheel_speed = 0.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const TricycleOdometryParams& params);

/// Motion of base_link in its own frame.
struct BaseVelocity {
  double forward = 0.0;    ///< v_lp (2.2) [m/s]
  double turn_rate = 0.0;  ///< omega_lp (2.3) [rad/s]
};

/// What became of a reading.
enum class OdometryVerdict {
  kFirst,       ///< the one that the next is compared with
  kIntegrated,  ///< pose and velocity are those of this reading
  kNotLater,    ///< left out: its stamp is that of the last one, or earlier
  kJump,        ///< more ticks than the wheel can do: pose stays, the counters are taken over
};

struct OdometryStep {
  OdometryVerdict verdict = OdometryVerdict::kFirst;
  std::int32_t ticks = 0;  ///< of the driven wheel since the reading before, 0 for the first
  Duration time{};         ///< since the reading before, 0 for the first
  double steering = 0.0;   ///< as measured, mean of both readings; only if integrated [rad]
};

/// Sums up the arcs between the readings of a tricycle's encoders to the pose of base_link in odom.
///
/// The steering of an arc is the mean of its ends, the shorter way round the encoder; its offset is
/// that of the driving direction, (2.6). Readings that are not later than the last one are left
/// out: the counters are sums, so what they told is in the next reading. After a clock was set back
/// call restart(), or all readings are left out until it has caught up. Not thread-safe.
class TricycleOdometry {
 public:
  /// Throws std::invalid_argument with the field and its value.
  TricycleOdometry(const TricycleParams& tricycle, const EncoderParams& encoders,
                   const Pose2& odom_T_base = {}, const TricycleOdometryParams& params = {});

  OdometryStep add(const EncoderReading& reading);

  /// Forgets the last reading and halts; the pose stays.
  void restart();

  const Pose2& odom_T_base() const { return odom_T_base_; }
  /// The mean over the last step that was integrated; 0 before the first one and after a jump.
  const BaseVelocity& velocity() const { return velocity_; }
  /// The last reading that counted.
  const std::optional<EncoderReading>& reading() const { return last_; }

 private:
  OdometryVerdict judge(const OdometryStep& step) const;
  void integrate(const EncoderReading& reading, OdometryStep& step);

  TricycleParams tricycle_;
  EncoderParams encoders_;
  TricycleOdometryParams params_;
  Pose2 odom_T_base_;
  BaseVelocity velocity_;
  std::optional<EncoderReading> last_;
};

}  // namespace falko_slam
