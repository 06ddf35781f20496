// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_conversion.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {
namespace {

std::vector<CalibratedParameter> parameters_of(const CalibrationEstimate& estimate) {
  const CalibrationVector values = vector_of(estimate.calibration);
  std::vector<CalibratedParameter> parameters(kCalibrationParameters);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    parameters[i].name = name_of(static_cast<CalibrationParameter>(i));
    parameters[i].value = values(row);
    parameters[i].deviation = std::sqrt(estimate.covariance(row, row));
    parameters[i].low = estimate.intervals[i].low;
    parameters[i].high = estimate.intervals[i].high;
  }
  return parameters;
}

}  // namespace

CalibrationArc to_message(const SessionArc& arc) {
  CalibrationArc message;
  message.complaint = arc.recorded.complaint;
  if (!message.complaint.empty()) return message;
  const PathSegment& segment = arc.recorded.segment;
  message.phase = name_of(phase_of(segment));
  message.ticks = segment.ticks;
  message.steering = segment.steering;
  const Pose2& motion = segment.start_T_end.pose;
  message.start_T_end = pose2d(motion.x(), motion.y(), motion.theta());
  message.turn = segment.turn;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> covariance = segment.start_T_end.covariance;
  std::copy(covariance.data(), covariance.data() + 9, message.covariance.begin());
  message.reflectors = static_cast<std::uint32_t>(arc.recorded.motion.pairs.size());
  if (arc.residual)
    message.residual = pose2d(arc.residual->x(), arc.residual->y(), arc.residual->z());
  message.used = true;
  return message;
}

PathSegment from_message(const CalibrationArc& message) {
  PathSegment segment;
  segment.ticks = message.ticks;
  segment.steering = message.steering;
  segment.turn = message.turn;
  segment.start_T_end.pose =
      Pose2(message.start_T_end.x, message.start_T_end.y, message.start_T_end.theta);
  segment.start_T_end.covariance =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(message.covariance.data());
  return segment;
}

CalibrationOutcome to_message(const CalibrationResult& result) {
  CalibrationOutcome message;
  message.verdict = name_of(result.verdict);
  for (const CalibrationRemark& remark : result.remarks) {
    message.remarks.push_back(remark.remedy.empty() ? remark.reason
                                                    : remark.reason + ": " + remark.remedy);
  }
  for (const CalibrationParameter parameter : result.tied) {
    message.tied.emplace_back(name_of(parameter));
  }
  if (!result.estimate) return message;
  message.parameters = parameters_of(*result.estimate);
  const CalibrationMatrix& covariance = result.estimate->covariance;  // symmetric
  message.covariance.assign(covariance.data(), covariance.data() + covariance.size());
  message.chi2 = result.estimate->chi2;
  message.degrees_of_freedom = result.estimate->degrees_of_freedom;
  return message;
}

void add_reports(std::vector<CalibrationArc>& arcs, const CalibrationResult& result,
                 const std::vector<std::size_t>& which) {
  for (CalibrationArc& arc : arcs) {
    arc.used = false;
    arc.residual = {};
    arc.chi2 = 0.0;
  }
  if (!result.estimate) return;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const SegmentReport& report = result.estimate->segments.at(i);
    CalibrationArc& arc = arcs.at(which[i]);
    arc.residual = pose2d(report.residual.x(), report.residual.y(), report.residual.z());
    arc.chi2 = report.chi2;
    arc.used = report.used;
  }
}

}  // namespace falko_slam
