// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/extrinsic_calibration.hpp"

#include <cmath>

namespace falko_slam {
namespace {

constexpr double kTurnThatTellsTheWay = 0.1;  // [rad]
// Least share of a pivot that is no rounding.
constexpr double kLeastIndependent = 1e-12;

}  // namespace

Eigen::Vector2d base_displacement(const PathSegment& segment, const TricycleParams& tricycle) {
  const double direction = true_steering(tricycle, segment.steering, segment.ticks);
  double forward = tricycle.driving_scale * segment.ticks * std::cos(direction);
  if (std::abs(segment.turn) >= kTurnThatTellsTheWay) {
    forward = tricycle.wheelbase / std::tan(direction) * segment.turn;
  }
  return Pose2::exp({forward, 0.0, segment.turn}).translation();
}

// With E in the axes of phi = (l_x, l_y, cos l_theta, sin l_theta) and M, P of (2.32), (2.37),
// l_pos follows from phi_ang by the first two rows, and what is left is
//
//   E = mu_2 - 2 num^T phi_ang + const,   num = P_ang - (1 / m_1) [m_2 -m_3; m_3 m_2]^T P_pos
//
// on the unit circle: least where phi_ang points along num, which is lambda = mu_2 - |num|.
std::optional<Pose2> calibrate_laser_pose(const std::vector<PathSegment>& segments,
                                          const TricycleParams& tricycle) {
  double m_1 = 0.0, m_2 = 0.0, m_3 = 0.0, m_4 = 0.0;
  Eigen::Vector2d P_pos = Eigen::Vector2d::Zero(), P_ang = Eigen::Vector2d::Zero();
  for (const PathSegment& segment : segments) {
    const Eigen::Vector2d r = base_displacement(segment, tricycle);
    const Eigen::Vector2d& s = segment.start_T_end.pose.translation();
    const double sine = std::sin(segment.turn);
    const double versine = 2.0 * std::pow(std::sin(0.5 * segment.turn), 2);  // 1 - cos
    m_1 += 2.0 * versine;                                                    // (2.33)
    m_2 += s.x() * versine - s.y() * sine;                                   // (2.34)
    m_3 += s.x() * sine + s.y() * versine;                                   // (2.35)
    m_4 += s.squaredNorm();                                                  // (2.36)
    P_pos += Eigen::Vector2d(versine * r.x() - sine * r.y(), sine * r.x() + versine * r.y());
    P_ang += Eigen::Vector2d(s.dot(r), s.x() * r.y() - s.y() * r.x());
  }
  const double independent = m_1 * m_4 - m_2 * m_2 - m_3 * m_3;  // m_1 mu_2
  if (!(m_1 > 0.0 && independent > kLeastIndependent * m_1 * m_4)) return std::nullopt;
  Eigen::Matrix2d coupling;
  coupling << m_2, -m_3, m_3, m_2;
  const Eigen::Vector2d num = P_ang - coupling.transpose() * P_pos / m_1;
  if (!(num.norm() > 0.0)) return std::nullopt;
  const Eigen::Vector2d position = (P_pos - coupling * num.normalized()) / m_1;
  return Pose2(position, std::atan2(num.y(), num.x()));
}

}  // namespace falko_slam
