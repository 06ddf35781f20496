// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_model.hpp"

#include <cmath>

namespace falko_slam {
namespace {

constexpr Eigen::Index column(CalibrationParameter parameter) {
  return static_cast<Eigen::Index>(index_of(parameter));
}

// Base's motion r with its derivatives, arc by arc.
struct BaseMotion {
  Pose2 start_T_base;
  double turn = 0.0;
  Eigen::Matrix<double, 3, kCalibrationParameters> dparameters =
      Eigen::Matrix<double, 3, kCalibrationParameters>::Zero();
  Eigen::Vector3d dslip = Eigen::Vector3d::Zero(), dsteer = Eigen::Vector3d::Zero();

  void drive(const VehicleCalibration& calibration, const ArcControl& arc,
             const EncoderError& error);
};

void BaseMotion::drive(const VehicleCalibration& calibration, const ArcControl& arc,
                       const EncoderError& error) {
  if (arc.ticks == 0.0) return;
  const TricycleParams& tricycle = calibration.tricycle;
  const double ticks = arc.ticks * (1.0 + error.slip);
  const double steering = calibration.steer_gain * arc.steering + error.steer;
  const Pose2 before_T_after = drive_arc(tricycle, ticks, steering);
  const ArcJacobians arc_slopes = arc_jacobians(tricycle, ticks, steering);
  const ComposeJacobians slopes = compose_jacobians(start_T_base, before_T_after);
  const Eigen::Matrix3d& after = slopes.dresult_dright;
  const Eigen::Vector3d dsteering = after * arc_slopes.darc_dcontrol.col(1);

  dparameters = slopes.dresult_dleft * dparameters;
  dslip = slopes.dresult_dleft * dslip + after * arc_slopes.darc_dcontrol.col(0) * arc.ticks;
  dsteer = slopes.dresult_dleft * dsteer + dsteering;
  const auto offset = ticks > 0.0 ? CalibrationParameter::kSteerOffsetForward
                                  : CalibrationParameter::kSteerOffsetBackward;
  dparameters.col(column(offset)) += after * arc_slopes.darc_dparams.col(2);
  dparameters.col(column(CalibrationParameter::kDrivingScale)) +=
      after * arc_slopes.darc_dparams.col(1);
  dparameters.col(column(CalibrationParameter::kWheelbase)) +=
      after * arc_slopes.darc_dparams.col(0);
  dparameters.col(column(CalibrationParameter::kSteerGain)) += dsteering * arc.steering;

  start_T_base = start_T_base * before_T_after;
  turn += tricycle.driving_scale * ticks * std::sin(true_steering(tricycle, steering, ticks)) /
          tricycle.wheelbase;
}

}  // namespace

MeasuredStretch stretch_of(const PathSegment& segment) {
  const Pose2& pose = segment.start_T_end.pose;
  return {{{segment.ticks, segment.steering}},
          {pose.x(), pose.y(), segment.turn},
          segment.start_T_end.covariance,
          segment.covariance_with_next};
}

// s_pos = R(l_theta)^T v with v = r_pos + (R(r_theta) - I) l_pos, s_theta = r_theta.
StretchPrediction predict(const VehicleCalibration& calibration,
                          const std::vector<ArcControl>& arcs, const EncoderError& error) {
  BaseMotion base;
  for (const ArcControl& arc : arcs) base.drive(calibration, arc, error);
  const Pose2& l = calibration.base_T_laser;
  const Eigen::Matrix2d R_r = base.start_T_base.rotation();
  const Eigen::Matrix2d R_l_transposed = l.rotation().transpose();
  const Eigen::Matrix2d turned = R_r - Eigen::Matrix2d::Identity();
  const Eigen::Vector2d arm = R_r * l.translation();
  const Eigen::Vector2d s =
      R_l_transposed * (base.start_T_base.translation() + turned * l.translation());

  Eigen::Matrix3d dbase = Eigen::Matrix3d::Identity();
  dbase.topLeftCorner<2, 2>() = R_l_transposed;
  dbase.topRightCorner<2, 1>() = R_l_transposed * Eigen::Vector2d(-arm.y(), arm.x());
  StretchPrediction prediction;
  prediction.motion << s, base.turn;
  prediction.dparameters = dbase * base.dparameters;
  prediction.dparameters.block<2, 2>(0, column(CalibrationParameter::kLaserX)) =
      R_l_transposed * turned;
  prediction.dparameters.col(column(CalibrationParameter::kLaserTheta)) << s.y(), -s.x(), 0.0;
  prediction.dslip = dbase * base.dslip;
  prediction.dsteer = dbase * base.dsteer;
  return prediction;
}

}  // namespace falko_slam
