// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// The derivatives of A = sin(theta) / theta and B = (1 - cos(theta)) / theta, smooth through zero.
struct ArcFactorSlopes {
  double along;
  double across;
};

ArcFactorSlopes arc_factor_slopes(double theta) {
  const double theta2 = theta * theta;
  if (std::abs(theta) < 0.02) {
    return {theta * (-1.0 / 3.0 + theta2 * (1.0 / 30.0 - theta2 / 840.0)),
            0.5 + theta2 * (-1.0 / 8.0 + theta2 * (1.0 / 144.0 - theta2 / 5760.0))};
  }
  const double half_sine = std::sin(0.5 * theta);  // 1 - cos without cancellation
  return {(theta * std::cos(theta) - std::sin(theta)) / theta2,
          (theta * std::sin(theta) - 2.0 * half_sine * half_sine) / theta2};
}

}  // namespace

void validate(const TricycleParams& params) {
  require_in_range("wheelbase", params.wheelbase, 0.05, 20.0);
  require_in_range("driving_scale", params.driving_scale, 1e-9, 1.0);
  require_in_range("steer_offset_forward", params.steer_offset_forward, -kPi, kPi);
  require_in_range("steer_offset_backward", params.steer_offset_backward, -kPi, kPi);
}

double true_steering(const TricycleParams& params, double steering, double ticks) {
  return steering + (ticks > 0.0 ? params.steer_offset_forward : params.steer_offset_backward);
}

// An arc is the exponential of a constant twist: (2.2), (2.3) times the time.
Pose2 drive_arc(const TricycleParams& params, double ticks, double steering) {
  const double way = params.driving_scale * ticks;
  const double direction = true_steering(params, steering, ticks);
  return Pose2::exp({way * std::cos(direction), 0.0, way * std::sin(direction) / params.wheelbase});
}

// With the way w = s_w n and the wheel's direction a the arc is
//
//   theta = w sin(a) / L,    x = w cos(a) A(theta),    y = w cos(a) B(theta)
//
// and therefore, A' and B' being the slopes of A and B,
//
//   d/dw = (cos(a) cos(theta), cos(a) sin(theta), sin(a) / L)    the twist at the arc's end
//   d/da = (w cos(a) A' dtheta/da - w sin(a) A, the same of B, w cos(a) / L)
//   d/dL = (w cos(a) A' dtheta/dL,              the same of B, -theta / L)
ArcJacobians arc_jacobians(const TricycleParams& params, double ticks, double steering) {
  const double direction = true_steering(params, steering, ticks);
  const double cosine = std::cos(direction);
  const double sine = std::sin(direction);
  const double w = params.driving_scale * ticks;
  const double L = params.wheelbase;
  const double theta = w * sine / L;
  const auto [along_slope, across_slope] = arc_factor_slopes(theta);
  const Eigen::Vector3d dfactors(w * cosine * along_slope, w * cosine * across_slope, 1.0);
  const Pose2 across = Pose2::exp({w * sine, 0.0, theta});  // (w sin(a) A, w sin(a) B)

  const Eigen::Vector3d dway(cosine * std::cos(theta), cosine * std::sin(theta), sine / L);
  const Eigen::Vector3d ddirection =
      dfactors * (w * cosine / L) - Eigen::Vector3d(across.x(), across.y(), 0.0);
  const Eigen::Vector3d dwheelbase = dfactors * (-theta / L);
  ArcJacobians jacobians;
  jacobians.darc_dcontrol << params.driving_scale * dway, ddirection;
  jacobians.darc_dparams << dwheelbase, ticks * dway, ddirection;
  return jacobians;
}

Pose2 drive_rk2(const TricycleParams& params, double ticks, const SteeringSweep& steering) {
  const double way = params.driving_scale * ticks;
  const double S_L = way / params.wheelbase;                               // (5.9)
  const double middle = 0.5 * (steering.after + steering.before);          // (5.10)
  const double quarter = 0.25 * (steering.after + 3.0 * steering.before);  // (5.11)
  const double alpha_2 = true_steering(params, middle, ticks);
  const double alpha_34 = true_steering(params, quarter, ticks);
  const double halfway = 0.5 * S_L * std::sin(alpha_34);  // the heading there
  const double forward = way * std::cos(alpha_2);
  return {forward * std::cos(halfway), forward * std::sin(halfway), S_L * std::sin(alpha_2)};
}

}  // namespace falko_slam
