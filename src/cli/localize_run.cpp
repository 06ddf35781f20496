// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string line_of(const LocalizerReport& report) {
  std::ostringstream out;
  out << fixed_text(to_seconds(report.stamp.time_since_epoch()), 6) << "," << name_of(report.status)
      << "," << name_of(report.reason) << "," << fixed_text(report.evidence, 2) << ","
      << report.agreement.used << "," << report.agreement.strangers << ","
      << report.agreement.expected << "," << report.agreement.missed << ","
      << fixed_text(report.agreement.nis, 3) << "," << report.agreement.degrees_of_freedom << ","
      << report.hypotheses;
  if (report.map_T_base) {
    const auto& [pose, covariance] = *report.map_T_base;
    out << "," << fixed_text(pose.x(), 5) << "," << fixed_text(pose.y(), 5) << ","
        << fixed_text(pose.theta(), 6);
    for (int i = 0; i < 3; ++i) out << "," << fixed_text(std::sqrt(covariance(i, i)), 6);
  } else {
    out << ",,,,,,";
  }
  out << "\n";
  return out.str();
}

}  // namespace

LocalizeRun::LocalizeRun(const LocalizerParams& params, const LandmarkMap& map,
                         const ScanNormalizerParams& scanner, const Trajectory& truth)
    : scanner_(scanner), localizer_(params, map), truth_(truth) {
  table_ =
      "stamp,status,reason,evidence,used,strangers,expected,missed,nis,degrees_of_freedom,"
      "hypotheses,x,y,theta,x_deviation,y_deviation,theta_deviation\n";
}

void LocalizeRun::add(const RawScan& raw) {
  const auto begin = Clock::now();
  if (!normalize(raw, scanner_, scan_).usable()) {
    ++unusable_;
    return;
  }
  const LocalizerReport& report = localizer_.add_scan(scan_);
  note(report, seconds_since(begin));
}

void LocalizeRun::add(Time stamp, const std::vector<LandmarkObservation>& reflectors) {
  const auto begin = Clock::now();
  const LocalizerReport& report = localizer_.add_reflectors(stamp, reflectors);
  note(report, seconds_since(begin));
}

void LocalizeRun::note(const LocalizerReport& report, double seconds) {
  ++scans_;
  ++status_[static_cast<std::size_t>(report.status)];
  seconds_ += seconds;
  max_seconds_ = std::max(max_seconds_, seconds);
  table_ += line_of(report);
  if (!report.map_T_base) return;
  const Pose2& pose = report.map_T_base->pose;
  trajectory_.push_back({report.stamp, pose});
  const auto truth = truth_.interpolate(report.stamp, std::chrono::seconds(1));
  if (!truth) return;
  errors_.translation.push_back((pose.translation() - truth->translation()).norm());
  errors_.rotation.push_back(std::abs(wrap_angle(pose.theta() - truth->theta())));
}

double LocalizeRun::mean_seconds() const {
  return scans_ == 0 ? 0.0 : seconds_ / static_cast<double>(scans_);
}

}  // namespace cli
}  // namespace falko_slam
