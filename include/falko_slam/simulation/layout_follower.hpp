// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/simulation/layout.hpp"
#include "falko_slam/vehicle/tricycle.hpp"
#include "falko_slam/vehicle/wheel_command.hpp"

namespace falko_slam {

struct LayoutFollowerParams {
  TricycleParams tricycle;     ///< as calibrated: its offsets are taken off what is commanded
  double steer_gain = 1.0;     ///< of the measured steering, before the offset, [0.01, 100]
  double acceleration = 0.5;   ///< of the wheel [m/s^2], (0, 10]
  double max_steering = 1.2;   ///< to either side [rad], (0, 1.5]
  double response = 0.5;       ///< way on which an error dies down, at rest [m], [0.05, 10]
  double response_time = 0.5;  ///< and more with speed [s], [0, 10]
  double max_sideways = 0.6;   ///< acceleration in curves [m/s^2], (0, 10]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LayoutFollowerParams& params);

/// What a vehicle knows of itself.
struct PosedMotion {
  Time stamp{};
  std::optional<Pose2> map_T_base;  ///< as a localizer has it; empty: it does not know
  double speed = 0.0;               ///< of base_link along its x axis [m/s]
  std::optional<double> steering;   ///< as the encoder measures it [rad]; empty: it is not known
};

/// Where a vehicle has come to stand.
struct Halt {
  std::string name;          ///< of the path that ends here; may be empty
  Time stamp{};              ///< [s]
  Pose2 map_T_planned;       ///< the end of the path, heading as the vehicle should
  Pose2 map_T_base;          ///< where the vehicle takes itself to be
  bool after_curve = false;  ///< the path's last metre is not straight
};

/// Leads a tricycle along a layout by the pose that a localizer gives; for simulations and trials,
/// not a navigation stack: there are no obstacles and no traffic.
///
/// The rear axle follows the path: the curvature of the way is the path's less feedback of the
/// distance e and of the angle phi to it, kappa = kappa_path - e / r^2 -+ 2 phi / r (- forwards, +
/// backwards), critically damped over the way r = response + response_time * speed, however fast
/// the vehicle drives. It slows down for curves, and while the wheel is not yet steered as it
/// should be; it brakes so that it stands at the end of each path, and at once while there is no
/// pose. The paths are the same for all vehicles: each begins where the one before ends, the first
/// one where the vehicle is.
class LayoutFollower {
 public:
  /// Throws std::invalid_argument for parameters that are none, or a layout without steps.
  LayoutFollower(const LayoutFollowerParams& params, Layout layout);
  ~LayoutFollower();
  LayoutFollower(LayoutFollower&&) noexcept;
  LayoutFollower& operator=(LayoutFollower&&) noexcept;

  /// What the wheel should do now; motions come in the order of their stamps.
  WheelCommand next(const PosedMotion& motion);

  bool done() const;
  /// From the first step on once more; its path begins where the last one ended. Halts are
  /// forgotten.
  void begin_again();
  /// All until now, those without a name included.
  const std::vector<Halt>& halts() const;
  /// Of the path to where it is [m], positive: to the left of it; 0 while it waits.
  double cross_track() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace falko_slam
