// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/localization_evaluation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Sums up errors; finish() makes means of the sums.
class RunTally {
 public:
  RunTally(const SimulatedDrive& drive, const RightPose& right)
      : truth_(drive.truth), right_(right) {}

  void add(const LocalizerReport& report, double seconds) {
    ++run_.scans;
    ++run_.status[static_cast<std::size_t>(report.status)];
    ++run_.reasons[static_cast<std::size_t>(report.reason)];
    run_.mean_time += seconds;
    run_.max_time = std::max(run_.max_time, seconds);
    nis_ += report.agreement.nis;
    freedom_ += report.agreement.degrees_of_freedom;
    run_.landmarks += static_cast<double>(report.agreement.used);
    const auto truth = truth_.interpolate(report.stamp, std::chrono::seconds(1));
    if (report.map_T_base && truth) add_error(report, *truth);
  }

  LocalizationRun finish() {
    const double scans = std::max<double>(1.0, static_cast<double>(run_.scans));
    const double posed = std::max<double>(1.0, static_cast<double>(run_.posed));
    run_.mean_time /= scans;
    run_.landmarks /= scans;
    run_.nis = nis_ / std::max(1, freedom_);
    run_.nees /= 3.0 * posed;
    run_.position_bias_x /= posed;
    run_.position_bias_y /= posed;
    run_.position_rmse = std::sqrt(run_.position_rmse / posed);
    run_.heading_rmse = std::sqrt(run_.heading_rmse / posed);
    return run_;
  }

 private:
  void add_error(const LocalizerReport& report, const Pose2& truth) {
    const PoseEstimate& pose = *report.map_T_base;
    const Eigen::Vector2d shift = pose.pose.translation() - truth.translation();
    const double turn = wrap_angle(pose.pose.theta() - truth.theta());
    const Eigen::Vector2d in_base = truth.rotation().transpose() * shift;
    const Eigen::Vector3d error(shift.x(), shift.y(), turn);
    ++run_.posed;
    run_.position_rmse += shift.squaredNorm();
    run_.heading_rmse += turn * turn;
    run_.position_max = std::max(run_.position_max, shift.norm());
    run_.heading_max = std::max(run_.heading_max, std::abs(turn));
    run_.position_bias_x += in_base.x();
    run_.position_bias_y += in_base.y();
    run_.nees += error.dot(pose.covariance.inverse() * error);
    const bool wrong = shift.norm() > right_.position || std::abs(turn) > right_.heading;
    if (wrong && report.status == LocalizationStatus::kOk) ++run_.wrong_ok;
  }

  TrajectoryIndex truth_;
  RightPose right_;
  LocalizationRun run_;
  double nis_ = 0.0;
  int freedom_ = 0;
};

}  // namespace

LocalizationRun evaluate_localization(const SimulatedDrive& drive, LocalizerParams params,
                                      const LandmarkMap& map, const RightPose& right) {
  params.base_T_laser = drive.base_T_laser;
  Localizer localizer(params, map);
  const StampedPose& first = drive.truth.front();
  localizer.set_pose(first.stamp, PoseEstimate{first.map_T_base, pose_covariance(0.02, 0.005)});
  RunTally tally(drive, right);
  for (const DriveInputEvent& event : drive.events) {
    if (event.motion) localizer.add_motion(event.stamp, *event.motion);
    if (!event.scan) continue;
    const auto begin = std::chrono::steady_clock::now();
    const LocalizerReport& report = localizer.add_scan(*event.scan);
    tally.add(report,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return tally.finish();
}

}  // namespace falko_slam
