// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibrator.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "calibration_remarks.hpp"
#include "falko_slam/calibration/extrinsic_calibration.hpp"
#include "falko_slam/calibration/intrinsic_calibration.hpp"
#include "falko_slam/common/validation.hpp"
#include "joint_estimate.hpp"

namespace falko_slam {
namespace {

using Parameter = CalibrationParameter;
using Segments = std::vector<PathSegment>;

constexpr double kGreatestOffset = 0.6;   // [rad]: beyond, a sign is wrong
constexpr double kGreatestMisfit = 0.05;  // of the way of a segment, in the middle of all

void add(CalibrationResult& result, const CalibrationRemark& remark) {
  result.remarks.push_back(remark);
  result.verdict = std::max(result.verdict, remark.verdict);
}

bool gives_numbers(const CalibrationResult& result) {
  return result.verdict < CalibrationVerdict::kUnobservable;
}

// Step 1.
void check(const Segments& segments, const CalibratorParams& params, CalibrationResult& result) {
  result.observability = check_observability(segments, params.model, params.observability);
  result.verdict = result.observability.verdict;
  result.remarks = result.observability.remarks;
}

// Step 2.
void solve_in_closed_form(const Segments& segments, const CalibratorParams& params,
                          CalibrationResult& result) {
  const auto tricycle = params.model == TricycleModel::kStandard
                            ? calibrate_standard(segments, params.wheelbase)
                            : calibrate_asymmetric(segments, params.wheelbase);
  if (!tricycle) {
    return add(result, {CalibrationVerdict::kUnobservable,
                        {Parameter::kDrivingScale},
                        "the laser does not turn",
                        "check the egomotion of the laser"});
  }
  const double forward = tricycle->steer_offset_forward, backward = tricycle->steer_offset_backward;
  if (std::max(std::abs(forward), std::abs(backward)) > kGreatestOffset) {
    std::ostringstream reason;
    reason << "the steer offsets would be " << forward << " and " << backward << " rad";
    return add(result, {CalibrationVerdict::kContradictory,
                        {Parameter::kSteerOffsetForward, Parameter::kSteerOffsetBackward},
                        reason.str(),
                        "check the signs of ticks, steering and egomotion"});
  }
  const auto laser = calibrate_laser_pose(segments, *tricycle);
  if (!laser) {
    return add(result, {CalibrationVerdict::kUnobservable,
                        {Parameter::kLaserX, Parameter::kLaserY, Parameter::kLaserTheta},
                        "the arcs have one centre of rotation",
                        "drive arcs of a half turn with other steering, on both sides"});
  }
  result.closed_form = VehicleCalibration{*tricycle, params.steer_gain, *laser};
}

Segments sound_segments(const Segments& segments, const CalibrationEstimate& estimate) {
  Segments sound;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (estimate.segments[i].used) sound.push_back(segments[i]);
  }
  return sound;
}

void check_misfit(const Segments& segments, const CalibrationEstimate& estimate,
                  CalibrationResult& result) {
  std::vector<double> misfits;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double way = std::abs(estimate.calibration.tricycle.driving_scale * segments[i].ticks);
    misfits.push_back(estimate.segments[i].residual.head<2>().norm() / way);
  }
  const auto middle = misfits.begin() + static_cast<std::ptrdiff_t>(misfits.size() / 2);
  std::nth_element(misfits.begin(), middle, misfits.end());
  if (*middle <= kGreatestMisfit) return;
  std::ostringstream reason;
  reason << "no tricycle drives like that: half of the segments end more than "
         << std::round(100.0 * *middle) << " % of their way beside what is expected";
  add(result, {CalibrationVerdict::kContradictory,
               {},
               reason.str(),
               "check the signs and units of ticks, steering and egomotion"});
}

StretchSet stretches_of(const Segments& segments) {
  StretchSet set;
  for (const PathSegment& segment : segments) {
    set.stretches.push_back(stretch_of(segment));
    set.phases.push_back(static_cast<std::size_t>(phase_of(segment)));
  }
  set.used.assign(segments.size(), true);
  return set;
}

// The measured steering as the wheel has it.
Segments geared(Segments segments, double steer_gain) {
  for (PathSegment& segment : segments) segment.steering *= steer_gain;
  return segments;
}

// Steps 3 to 5.
void refine(const Segments& segments, const CalibratorParams& params, CalibrationResult& result) {
  const VehicleCalibration start = params.start.value_or(*result.closed_form);
  const FreeParameters free =
      free_parameters({params.model, params.free_wheelbase, params.free_steer_gain}, start);
  StretchSet set = stretches_of(segments);
  auto joint = estimate_jointly(set, free, start, params.noise, params.outliers);
  if (!joint) {
    return add(result,
               {CalibrationVerdict::kUnobservable, {}, "the equations are singular", "drive more"});
  }
  check(geared(sound_segments(segments, joint->estimate), params.steer_gain), params, result);
  check_misfit(segments, joint->estimate, result);
  if (!gives_numbers(result)) return;
  result.tied = tied_parameters(joint->estimate.covariance);
  for (const auto& remark :
       remarks_on(set, free, *joint, result.tied, {params.limits, params.noise})) {
    add(result, remark);
  }
  result.estimate = std::move(joint->estimate);
}

}  // namespace

void validate(const CalibratorParams& params) {
  require_in_range("wheelbase", params.wheelbase, 0.05, 20.0);
  require_in_range("steer_gain", params.steer_gain, 0.01, 100.0);
  validate(params.noise);
  validate(params.observability);
  validate(params.limits);
  validate(params.outliers);
  if (params.start) validate(params.start->tricycle);
}

CalibrationResult calibrate(const std::vector<PathSegment>& segments,
                            const CalibratorParams& params) {
  validate(params);
  validate(segments);
  const Segments driven = geared(segments, params.steer_gain);
  CalibrationResult result;
  check(driven, params, result);
  if (gives_numbers(result)) solve_in_closed_form(driven, params, result);
  if (gives_numbers(result)) refine(segments, params, result);
  if (!gives_numbers(result)) result.closed_form.reset();
  return result;
}

}  // namespace falko_slam
