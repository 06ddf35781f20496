// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_remarks.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>

#include "falko_slam/common/validation.hpp"
#include "next_arc.hpp"

namespace falko_slam {
namespace {

using Parameter = CalibrationParameter;

constexpr double kTied = 3.0;       // times the standard deviation if all others were known
constexpr double kTakesPart = 0.4;  // component of a unit vector

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

double correlation_of(const CalibrationMatrix& covariance, Parameter a, Parameter b) {
  return covariance(row(a), row(b)) /
         std::sqrt(covariance(row(a), row(a)) * covariance(row(b), row(b)));
}

// All that were free. The offsets of the standard model are one.
std::vector<Parameter> independent_parameters(const CalibrationMatrix& covariance) {
  std::vector<Parameter> known;
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto parameter = static_cast<Parameter>(i);
    if (!(covariance(row(parameter), row(parameter)) > 0.0)) continue;
    const bool again =
        parameter == Parameter::kSteerOffsetBackward &&
        correlation_of(covariance, Parameter::kSteerOffsetForward, parameter) > 1.0 - 1e-9;
    if (!again) known.push_back(parameter);
  }
  return known;
}

void add_weak_parameters(const StretchSet& set, const FreeParameters& free,
                         const JointEstimate& joint, const RemarkParams& params,
                         std::vector<CalibrationRemark>& remarks) {
  const VehicleCalibration& calibration = joint.estimate.calibration;
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto parameter = static_cast<Parameter>(i);
    const double deviation = std::sqrt(joint.estimate.covariance(row(parameter), row(parameter)));
    const double limit = limit_of(parameter, params.limits, calibration);
    if (deviation <= limit) continue;
    std::ostringstream reason;
    reason << name_of(parameter) << " has a standard deviation of " << deviation << ", more than "
           << limit;
    remarks.push_back({CalibrationVerdict::kWeak,
                       {parameter},
                       reason.str(),
                       params.arcs ? next_arc_for(parameter, set, free, joint, params.noise)
                                   : "drive more, and more variously"});
  }
}

void add_outliers(const CalibrationEstimate& estimate, bool arcs,
                  std::vector<CalibrationRemark>& remarks) {
  for (std::size_t i = 0; i < estimate.segments.size(); ++i) {
    const SegmentReport& segment = estimate.segments[i];
    if (segment.used) continue;
    std::ostringstream reason;
    reason << (arcs ? "segment " : "window ") << i + 1 << " (" << name_of(segment.phase)
           << ") was left out, chi2 " << segment.chi2;
    remarks.push_back({CalibrationVerdict::kOk, {}, reason.str(), "look at its residual"});
  }
}

}  // namespace

void validate(const CalibrationLimits& limits) {
  require_in_range("limits.steer_offset", limits.steer_offset, 1e-9, 1.0);
  require_in_range("limits.driving_scale", limits.driving_scale, 1e-9, 1.0);
  require_in_range("limits.laser_position", limits.laser_position, 1e-9, 10.0);
  require_in_range("limits.laser_theta", limits.laser_theta, 1e-9, 1.0);
  require_in_range("limits.wheelbase", limits.wheelbase, 1e-9, 1.0);
  require_in_range("limits.steer_gain", limits.steer_gain, 1e-9, 1.0);
}

std::string list_of(const std::vector<CalibrationParameter>& parameters) {
  std::string names;
  for (const Parameter parameter : parameters) {
    names += (names.empty() ? "" : ", ") + std::string(name_of(parameter));
  }
  return names;
}

std::vector<CalibrationParameter> tied_parameters(const CalibrationMatrix& covariance) {
  const std::vector<Parameter> known = independent_parameters(covariance);
  const auto count = static_cast<Eigen::Index>(known.size());
  Eigen::MatrixXd correlation(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      correlation(i, j) = correlation_of(covariance, known[static_cast<std::size_t>(i)],
                                         known[static_cast<std::size_t>(j)]);
    }
  }
  std::vector<Parameter> tied;
  if (count == 0) return tied;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(correlation);
  // Of the inverse: the squares of how much worse each is known than if all others were.
  const Eigen::VectorXd inflation =
      axes.eigenvectors().cwiseAbs2() * axes.eigenvalues().cwiseMax(1e-15).cwiseInverse();
  if (!(inflation.maxCoeff() > kTied * kTied)) return tied;
  const Eigen::VectorXd longest = axes.eigenvectors().col(count - 1);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (std::abs(longest[i]) > kTakesPart) tied.push_back(known[static_cast<std::size_t>(i)]);
  }
  return tied;
}

std::vector<CalibrationRemark> remarks_on(const StretchSet& set, const FreeParameters& free,
                                          const JointEstimate& joint,
                                          const std::vector<CalibrationParameter>& tied,
                                          const RemarkParams& params) {
  const CalibrationEstimate& estimate = joint.estimate;
  std::vector<CalibrationRemark> remarks;
  const auto weak = [&remarks](const std::vector<Parameter>& parameters, const std::string& reason,
                               const std::string& remedy) {
    remarks.push_back({CalibrationVerdict::kWeak, parameters, reason, remedy});
  };
  add_outliers(estimate, params.arcs, remarks);
  if (!estimate.converged) weak({}, "the estimate does not come to rest", "drive more");
  if (estimate.excess > 1.0) {
    std::ostringstream reason;
    reason << "chi2 is " << estimate.chi2 << " with " << estimate.degrees_of_freedom
           << " degrees of freedom: there is more noise than was said";
    weak({}, reason.str(), "measure the noise of egomotion, slip and steering");
  }
  if (!tied.empty()) {
    weak(tied, "the data tie " + list_of(tied) + " to each other",
         "measure one of them by other means and hold it");
  }
  add_weak_parameters(set, free, joint, params, remarks);
  return remarks;
}

}  // namespace falko_slam
