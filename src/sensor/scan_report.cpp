// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/scan_report.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace falko_slam {
namespace {

const char* name(BeamStatus status) {
  switch (status) {
    case BeamStatus::kValid:
      return "valid";
    case BeamStatus::kNoReturn:
      return "without return";
    case BeamStatus::kZero:
      return "zero";
    case BeamStatus::kTooNear:
      return "below range_min";
    case BeamStatus::kTooFar:
      return "above range_max";
    case BeamStatus::kErroneous:
      return "NaN";
  }
  return "unknown";
}

}  // namespace

std::string describe(const ScanReport& report) {
  if (report.fault == ScanFault::kNoBeams) return "no beams";
  std::ostringstream text;
  text << report.beam_count << (report.beam_count == 1 ? " beam" : " beams");
  if (report.fault == ScanFault::kBadAngles) {
    text << " with unusable angle_min, angle_max or angle_increment";
    return text.str();
  }
  for (std::size_t i = 0; i < kBeamStatusCount; ++i) {
    const auto status = static_cast<BeamStatus>(i);
    if (status != BeamStatus::kValid && report.count(status) == 0) continue;
    text << (i == 0 ? ": " : ", ") << report.count(status) << ' ' << name(status);
  }
  if (report.surplus_beams > 0) {
    text << "; " << report.surplus_beams << " beyond a full turn dropped";
  }
  if (std::abs(report.angle_max_excess) > 0.5) {
    text << "; angle_max is " << std::fixed << std::setprecision(1)
         << std::abs(report.angle_max_excess) << " beams "
         << (report.angle_max_excess > 0.0 ? "past" : "before") << " the last one";
  }
  if (report.angle_increment_derived) text << "; angle_increment taken from angle_max";
  if (report.missing_intensities > 0) {
    text << "; " << report.missing_intensities << " intensities missing";
  }
  return text.str();
}

}  // namespace falko_slam
