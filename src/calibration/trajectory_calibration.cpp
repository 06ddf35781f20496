// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/trajectory_calibration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "calibration_remarks.hpp"
#include "drive_windows.hpp"
#include "falko_slam/common/validation.hpp"
#include "joint_estimate.hpp"

namespace falko_slam {
namespace {

constexpr double kAsGoodAsNone = 1e-9;  // eigenvalue of an information with ones on its diagonal
constexpr double kIsMoved = 0.1;        // component of a unit vector

void validate(const std::vector<DriveRecord>& records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Pose2& pose = records[i].world_T_laser;
    if (!pose.translation().allFinite() || !std::isfinite(pose.theta())) {
      throw std::invalid_argument("records[" + std::to_string(i + 1) +
                                  "].world_T_laser: must be finite");
    }
  }
}

// Parameters that the drive does not determine, at the nominal values: those along the axis of the
// information, each measured by its own, that is as good as none.
std::vector<CalibrationParameter> undetermined(const StretchSet& set, const FreeParameters& free,
                                               const TrajectoryCalibratorParams& params) {
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(free.count(), free.count());
  for (const MeasuredStretch& stretch : set.stretches) {
    const StretchPrediction prediction = predict(params.nominal, stretch.arcs);
    const Eigen::Matrix3d covariance = residual_covariance(stretch, prediction, params.noise);
    const Eigen::MatrixXd H = prediction.dparameters * free.columns;
    information += H.transpose() * covariance.llt().solve(H);
  }
  Eigen::VectorXd axis;
  const Eigen::VectorXd own = information.diagonal().cwiseSqrt();
  if (own.minCoeff() > 0.0) {
    const Eigen::VectorXd by_own = own.cwiseInverse();
    const Eigen::MatrixXd scaled = by_own.asDiagonal() * information * by_own.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(scaled);
    if (axes.eigenvalues()[0] > kAsGoodAsNone) return {};
    axis = axes.eigenvectors().col(0);
  } else {
    axis = (own.array() <= 0.0).cast<double>();
  }
  const CalibrationVector moved = (free.columns * axis).cwiseAbs();
  const CalibrationVector scale = free.columns.cwiseAbs().rowwise().maxCoeff();
  std::vector<CalibrationParameter> parameters;
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (moved[row] > kIsMoved * scale[row]) {
      parameters.push_back(static_cast<CalibrationParameter>(i));
    }
  }
  return parameters;
}

void add(TrajectoryCalibrationResult& result, const CalibrationRemark& remark) {
  result.remarks.push_back(remark);
  result.verdict = std::max(result.verdict, remark.verdict);
}

// Steering and laser for the lengths as they are: from far away, all at once would lead to vehicles
// of negative length.
VehicleCalibration with_nominal_lengths(const StretchSet& set,
                                        const TrajectoryCalibratorParams& params) {
  FreeParameters free =
      free_parameters({params.model, false, params.free_steer_gain}, params.nominal);
  const auto scale = static_cast<Eigen::Index>(index_of(CalibrationParameter::kDrivingScale));
  free.columns.row(scale).setZero();
  return fit(set, free, params.nominal, params.noise, FitLoss::kNone).calibration;
}

// With its steering reversed a vehicle that drives backwards fits reversed ticks exactly.
bool is_vehicle(const VehicleCalibration& calibration) {
  return calibration.tricycle.wheelbase > 0.0 && calibration.tricycle.driving_scale > 0.0 &&
         calibration.steer_gain > 0.0;
}

}  // namespace

void validate(const TrajectoryCalibratorParams& params) {
  validate(params.nominal.tricycle);
  validate(params.encoders);
  validate(params.noise);
  validate(params.outliers);
  validate(params.limits);
  require_in_range("nominal.steer_gain", params.nominal.steer_gain, 0.01, 100.0);
  require_in_range("window", params.window, 0.01, 1e3);
  require_in_range("position_noise", params.position_noise, 1e-9, 10.0);
  require_in_range("heading_noise", params.heading_noise, 1e-9, 1.0);
  require_in_range("timing_noise", params.timing_noise, 0.0, 10.0);
}

DriveError drive_error(const std::vector<DriveRecord>& records, const EncoderParams& encoders,
                       const VehicleCalibration& calibration) {
  DriveError error;
  if (records.empty()) return error;
  const std::vector<ArcControl> controls = controls_of(records, encoders);
  const Pose2& laser = calibration.base_T_laser;
  Pose2 world_T_base = records.front().world_T_laser * laser.inverse();
  for (std::size_t i = 0; i < records.size(); ++i) {
    world_T_base = world_T_base * drive_arc(calibration.tricycle, controls[i].ticks,
                                            calibration.steer_gain * controls[i].steering);
    const double distance =
        (world_T_base * laser.translation() - records[i].world_T_laser.translation()).norm();
    error.mean += distance / static_cast<double>(records.size());
    error.greatest = std::max(error.greatest, distance);
  }
  return error;
}

TrajectoryCalibrationResult calibrate_trajectory(const std::vector<DriveRecord>& records,
                                                 const TrajectoryCalibratorParams& params) {
  validate(params);
  validate(records);
  TrajectoryCalibrationResult result;
  result.verdict = CalibrationVerdict::kOk;
  result.nominal_error = drive_error(records, params.encoders, params.nominal);
  const std::vector<ArcControl> controls = controls_of(records, params.encoders);
  result.windows = windows_of(controls, params.window / params.nominal.tricycle.driving_scale);
  StretchSet set = stretches_of(result.windows, records, controls, params);
  const FreeParameters free = free_parameters(
      {params.model, params.free_wheelbase, params.free_steer_gain}, params.nominal);
  const auto unknown = undetermined(set, free, params);
  if (!unknown.empty()) {
    add(result, {CalibrationVerdict::kUnobservable, unknown,
                 "the drive does not determine " + list_of(unknown),
                 "drive curves to both sides, in each direction that has an offset of its own"});
    return result;
  }
  const VehicleCalibration start = with_nominal_lengths(set, params);
  auto joint = estimate_jointly(set, free, start, params.noise, params.outliers);
  if (!joint || !is_vehicle(joint->estimate.calibration)) {
    add(result, {CalibrationVerdict::kContradictory,
                 {},
                 "no tricycle drives like that",
                 "check the signs and units of ticks, steering and poses"});
    return result;
  }
  result.tied = tied_parameters(joint->estimate.covariance);
  for (const auto& remark :
       remarks_on(set, free, *joint, result.tied, {params.limits, params.noise, false})) {
    add(result, remark);
  }
  result.error = drive_error(records, params.encoders, joint->estimate.calibration);
  result.estimate = std::move(joint->estimate);
  return result;
}

}  // namespace falko_slam
