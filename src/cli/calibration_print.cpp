// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_print.hpp"

#include <cmath>
#include <cstdio>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace cli {
namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// Units of the tables: those in which the parameters are thought of.
struct Unit {
  const char* name;
  double per_si;
};
Unit unit_of(CalibrationParameter parameter) {
  switch (parameter) {
    case CalibrationParameter::kSteerOffsetForward:
    case CalibrationParameter::kSteerOffsetBackward:
    case CalibrationParameter::kLaserTheta:
      return {"deg", radians_to_degrees(1.0)};
    case CalibrationParameter::kDrivingScale:
      return {"mm/tick", 1e3};
    case CalibrationParameter::kLaserX:
    case CalibrationParameter::kLaserY:
    case CalibrationParameter::kWheelbase:
      return {"mm", 1e3};
    case CalibrationParameter::kSteerGain:
      return {"", 1.0};
  }
  return {"", 1.0};
}

void print_remarks(std::ostream& out, CalibrationVerdict verdict,
                   const std::vector<CalibrationRemark>& remarks) {
  out << "verdict: " << name_of(verdict) << "\n";
  for (const CalibrationRemark& remark : remarks) {
    out << "  " << remark.reason;
    if (!remark.remedy.empty()) out << ": " << remark.remedy;
    out << "\n";
  }
}

void print_parameters(std::ostream& out, const CalibrationEstimate& estimate) {
  out << "parameter                      value    deviation    95 % interval\n";
  const CalibrationVector values = vector_of(estimate.calibration);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto parameter = static_cast<CalibrationParameter>(i);
    const auto row = static_cast<Eigen::Index>(i);
    const Unit unit = unit_of(parameter);
    const double deviation = std::sqrt(estimate.covariance(row, row)) * unit.per_si;
    const double value = values(row) * unit.per_si;
    if (deviation == 0.0) {
      out << line("%-22s %13.7g  held           %s\n", name_of(parameter), value, unit.name);
      continue;
    }
    const ParameterInterval& interval = estimate.intervals[i];
    out << line("%-22s %13.7g %12.3g    %.7g to %.7g %s\n", name_of(parameter), value, deviation,
                interval.low * unit.per_si, interval.high * unit.per_si, unit.name);
  }
  out << line("chi2 %.1f of %d degrees of freedom\n", estimate.chi2, estimate.degrees_of_freedom);
}

void print_tied(std::ostream& out, const std::vector<CalibrationParameter>& tied) {
  if (tied.empty()) return;
  out << "tied to each other:";
  for (const CalibrationParameter parameter : tied) out << " " << name_of(parameter);
  out << "\n";
}

bool from_scans(const std::vector<RecordedSegment>& recorded) {
  return !recorded.empty() && recorded.front().egomotion == EgomotionSource::kScans;
}

}  // namespace

void print_segments(std::ostream& out, const std::vector<RecordedSegment>& recorded,
                    const RecordedCalibration& calibration) {
  const bool scans = from_scans(recorded);
  out << line("segment  phase            steering     turn  %10s   x [mm]   y [mm] [cdeg]   chi2\n",
              scans ? "walls" : "reflectors");
  std::size_t next = 0;  // of the segments that count
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const RecordedSegment& found = recorded[i];
    if (!found.complaint.empty()) {
      out << line("%7zu  ", i + 1) << found.complaint << "\n";
      continue;
    }
    out << line("%7zu  %-15s %7.2f  %7.2f  %10zu", i + 1, name_of(phase_of(found.segment)),
                radians_to_degrees(found.segment.steering), radians_to_degrees(found.segment.turn),
                scans ? found.scan_motion.parts : found.motion.pairs.size());
    if (calibration.result.estimate) {
      const SegmentReport& report = calibration.result.estimate->segments.at(next);
      out << line(" %8.2f %8.2f %6.2f %6.1f%s", 1e3 * report.residual.x(),
                  1e3 * report.residual.y(), 1e2 * radians_to_degrees(report.residual.z()),
                  report.chi2, report.used ? "" : "  left out");
    }
    out << "\n";
    ++next;
  }
  if (scans) return;
  out << line("ranges of reflectors: %+.2f mm (%.2f)\n", 1e3 * calibration.range_offset.offset,
              1e3 * calibration.range_offset.deviation);
}

void print(std::ostream& out, const CalibrationResult& result) {
  if (result.estimate) print_parameters(out, *result.estimate);
  print_tied(out, result.tied);
  print_remarks(out, result.verdict, result.remarks);
}

void print(std::ostream& out, const TrajectoryCalibrationResult& result) {
  if (result.estimate) print_parameters(out, *result.estimate);
  print_tied(out, result.tied);
  out << line("odometry of the whole drive: mean error %.3f m, greatest %.3f m", result.error.mean,
              result.error.greatest)
      << line("; with the nominal values %.3f m, %.3f m\n", result.nominal_error.mean,
              result.nominal_error.greatest);
  print_remarks(out, result.verdict, result.remarks);
}

}  // namespace cli
}  // namespace falko_slam
