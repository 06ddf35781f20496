// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_remarks.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

using Parameter = CalibrationParameter;

constexpr double kTied = 10.0;      // times the standard deviation if all others were known
constexpr double kTakesPart = 0.3;  // of a unit vector's component

Eigen::Index row(Parameter parameter) { return static_cast<Eigen::Index>(index_of(parameter)); }

double limit_of(Parameter parameter, const CalibrationLimits& limits,
                const VehicleCalibration& calibration) {
  switch (parameter) {
    case Parameter::kSteerOffsetForward:
    case Parameter::kSteerOffsetBackward:
      return limits.steer_offset;
    case Parameter::kDrivingScale:
      return limits.driving_scale * calibration.tricycle.driving_scale;
    case Parameter::kLaserX:
    case Parameter::kLaserY:
      return limits.laser_position;
    case Parameter::kLaserTheta:
      return limits.laser_theta;
    case Parameter::kWheelbase:
      return limits.wheelbase * calibration.tricycle.wheelbase;
    case Parameter::kSteerGain:
      return limits.steer_gain * calibration.steer_gain;
  }
  return 0.0;
}

struct Arc {
  DrivePhase phase;
  double steering;
};

std::vector<Arc> possible_arcs() {
  std::vector<Arc> arcs;
  for (const DrivePhase phase : kAllDrivePhases) {
    const bool left = phase == DrivePhase::kForwardLeft || phase == DrivePhase::kBackwardLeft;
    for (const double degrees : {20.0, 30.0, 40.0, 50.0}) {
      arcs.push_back({phase, degrees_to_radians(left ? degrees : -degrees)});
    }
  }
  return arcs;
}

// Half a turn, seen as well as the others were on the average.
MeasuredStretch imagined(const Arc& arc, const VehicleCalibration& calibration,
                         const StretchSet& set) {
  const TricycleParams& tricycle = calibration.tricycle;
  const double ticks =
      kPi * tricycle.wheelbase / (tricycle.driving_scale * std::sin(std::abs(arc.steering)));
  MeasuredStretch stretch{{{is_forward(arc.phase) ? ticks : -ticks, arc.steering}}, {}, {}};
  stretch.covariance.setZero();
  for (const MeasuredStretch& other : set.stretches) stretch.covariance += other.covariance;
  stretch.covariance /= static_cast<double>(set.stretches.size());
  return stretch;
}

std::string best_arc(const StretchSet& set, const FreeParameters& free,
                     const VehicleCalibration& calibration, const Eigen::MatrixXd& covariance_of_x,
                     Parameter parameter, const CalibratorParams& params) {
  const Eigen::MatrixXd information = covariance_of_x.inverse();
  double least = std::numeric_limits<double>::infinity();
  Arc best{};
  for (const Arc& arc : possible_arcs()) {
    const MeasuredStretch stretch = imagined(arc, calibration, set);
    const StretchPrediction prediction = predict(calibration, stretch.arcs);
    const Eigen::Matrix3d covariance = residual_covariance(stretch, prediction, params.noise);
    const Eigen::MatrixXd H = prediction.dparameters * free.columns;
    const Eigen::MatrixXd more = information + H.transpose() * covariance.llt().solve(H);
    const Eigen::VectorXd by_x = free.columns.row(row(parameter)).transpose();
    const double variance = by_x.dot(more.llt().solve(by_x));
    if (variance >= least) continue;
    least = variance;
    best = arc;
  }
  std::ostringstream text;
  text << "drive more arcs " << name_of(best.phase) << ", half a turn steered by about "
       << std::round(radians_to_degrees(std::abs(best.steering))) << " degrees";
  return text.str();
}

}  // namespace

std::vector<CalibrationRemark> weak_parameters(const StretchSet& set, const FreeParameters& free,
                                               const VehicleCalibration& calibration,
                                               const Eigen::MatrixXd& covariance_of_x,
                                               const CalibratorParams& params) {
  const CalibrationMatrix covariance = free.columns * covariance_of_x * free.columns.transpose();
  std::vector<CalibrationRemark> remarks;
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto parameter = static_cast<Parameter>(i);
    const double deviation = std::sqrt(covariance(row(parameter), row(parameter)));
    const double limit = limit_of(parameter, params.limits, calibration);
    if (deviation <= limit) continue;
    std::ostringstream reason;
    reason << name_of(parameter) << " has a standard deviation of " << deviation << ", more than "
           << limit;
    remarks.push_back({CalibrationVerdict::kWeak,
                       {parameter},
                       reason.str(),
                       best_arc(set, free, calibration, covariance_of_x, parameter, params)});
  }
  return remarks;
}

std::vector<CalibrationParameter> tied_parameters(const CalibrationMatrix& covariance) {
  std::vector<Parameter> known;
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto parameter = static_cast<Parameter>(i);
    if (covariance(row(parameter), row(parameter)) > 0.0) known.push_back(parameter);
  }
  const auto count = static_cast<Eigen::Index>(known.size());
  Eigen::MatrixXd correlation(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const Eigen::Index a = row(known[static_cast<std::size_t>(i)]);
      const Eigen::Index b = row(known[static_cast<std::size_t>(j)]);
      correlation(i, j) = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
    }
  }
  const Eigen::LDLT<Eigen::MatrixXd> factors(correlation);
  const Eigen::MatrixXd inverse = factors.solve(Eigen::MatrixXd::Identity(count, count));
  std::vector<Parameter> tied;
  if (count == 0 || !(inverse.diagonal().maxCoeff() > kTied * kTied)) return tied;
  // What is stiff in the information is soft in nothing; the soft axis is that of the covariance
  // when each parameter is measured by what it would be known to if the others were.
  const Eigen::VectorXd alone = inverse.diagonal().cwiseSqrt();
  const Eigen::MatrixXd scaled = alone.asDiagonal() * correlation * alone.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(scaled);
  const Eigen::VectorXd softest = axes.eigenvectors().col(count - 1);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (std::abs(softest[i]) > kTakesPart) tied.push_back(known[static_cast<std::size_t>(i)]);
  }
  return tied;
}

}  // namespace falko_slam
