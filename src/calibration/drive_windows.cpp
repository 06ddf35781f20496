// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "drive_windows.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kNeighbours = 3;  // records on either side that tell a velocity

// How the laser moves in its own frame as a record is taken, (x, y, theta) per second.
Eigen::Vector3d velocity_at(const std::vector<DriveRecord>& records, std::size_t index) {
  const std::size_t before = index < kNeighbours ? 0 : index - kNeighbours;
  const std::size_t after = std::min(index + kNeighbours, records.size() - 1);
  const double time = to_seconds(records[after].encoders.stamp - records[before].encoders.stamp);
  if (!(time > 0.0)) return Eigen::Vector3d::Zero();
  return (records[before].world_T_laser.inverse() * records[after].world_T_laser).log() / time;
}

// Both ends are seen with the same noise, and a little sooner or later than the encoders are read:
// an end that is late by dt lies v dt further.
Eigen::Matrix3d covariance_of(const DriveWindow& window, const std::vector<DriveRecord>& records,
                              const TrajectoryCalibratorParams& params) {
  const Pose2& start = records[window.first].world_T_laser;
  const Pose2 start_T_end = start.inverse() * records[window.last].world_T_laser;
  const Eigen::Matrix3d pose = pose_covariance(params.position_noise, params.heading_noise);
  const PoseEstimate seen =
      compose(inverse(PoseEstimate{Pose2(), pose}), PoseEstimate{start_T_end, pose});
  const Eigen::Vector3d at_start = velocity_at(records, window.first);
  const Eigen::Vector3d at_end = velocity_at(records, window.last);
  const ComposeJacobians slopes = compose_jacobians(Pose2(), start_T_end);
  Eigen::Vector3d late_end = at_end;
  late_end.head<2>() = start_T_end.rotation() * at_end.head<2>();
  const Eigen::Vector3d late_start = -(slopes.dresult_dleft * at_start);
  return seen.covariance + std::pow(params.timing_noise, 2) * (late_end * late_end.transpose() +
                                                               late_start * late_start.transpose());
}

MeasuredStretch stretch_of(const DriveWindow& window, const std::vector<DriveRecord>& records,
                           const std::vector<ArcControl>& controls,
                           const TrajectoryCalibratorParams& params) {
  MeasuredStretch stretch;
  double turn = 0.0;
  for (std::size_t i = window.first + 1; i <= window.last; ++i) {
    if (controls[i].ticks != 0.0) stretch.arcs.push_back(controls[i]);
    turn += angle_between(records[i - 1].world_T_laser.theta(), records[i].world_T_laser.theta());
  }
  const Pose2 start_T_end =
      records[window.first].world_T_laser.inverse() * records[window.last].world_T_laser;
  stretch.motion << start_T_end.translation(), turn;
  stretch.covariance = covariance_of(window, records, params);
  return stretch;
}

// What most of the window was.
DrivePhase phase_of(const MeasuredStretch& stretch) {
  PathSegment all;
  for (const ArcControl& arc : stretch.arcs) {
    all.ticks += arc.ticks;
    all.steering += std::abs(arc.ticks) * arc.steering;
  }
  return falko_slam::phase_of(all);
}

}  // namespace

std::vector<ArcControl> controls_of(const std::vector<DriveRecord>& records,
                                    const EncoderParams& encoders) {
  std::vector<ArcControl> controls(records.size());
  for (std::size_t i = 1; i < records.size(); ++i) {
    const EncoderReading &before = records[i - 1].encoders, &now = records[i].encoders;
    const double turned = steering_between(encoders, before.steer_ticks, now.steer_ticks);
    controls[i] = {static_cast<double>(ticks_between(before.drive_ticks, now.drive_ticks)),
                   steering_of(encoders, before.steer_ticks) + 0.5 * turned};
  }
  return controls;
}

std::vector<DriveWindow> windows_of(const std::vector<ArcControl>& controls, double ticks) {
  std::vector<DriveWindow> windows;
  std::size_t first = 0;
  double driven = 0.0;
  for (std::size_t i = 1; i < controls.size(); ++i) {
    driven += std::abs(controls[i].ticks);
    const bool last = i + 1 == controls.size();
    if (driven < ticks && !(last && driven >= 0.5 * ticks)) continue;
    windows.push_back({first, i});
    first = i;
    driven = 0.0;
  }
  return windows;
}

StretchSet stretches_of(const std::vector<DriveWindow>& windows,
                        const std::vector<DriveRecord>& records,
                        const std::vector<ArcControl>& controls,
                        const TrajectoryCalibratorParams& params) {
  StretchSet set;
  for (const DriveWindow& window : windows) {
    set.stretches.push_back(stretch_of(window, records, controls, params));
    set.phases.push_back(static_cast<std::size_t>(phase_of(set.stretches.back())));
  }
  set.used.assign(windows.size(), true);
  return set;
}

}  // namespace falko_slam
