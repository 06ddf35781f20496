// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/soak.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/evaluation/simulated_drive.hpp"
#include "falko_slam/evaluation/vehicle_knowledge.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Sums up a period; means are made when it is over.
class SoakTally {
 public:
  SoakTally(const SoakParams& params, double scan_period,
            const std::function<void(const SoakPeriod&)>& each)
      : length_(60.0 * params.period_minutes), scan_period_(scan_period), each_(each) {}

  void add(const LayoutScan& scan) {
    if (!start_) start_ = scan.report.stamp;
    const double now = to_seconds(scan.report.stamp - *start_);
    if (now >= sum_.begin + length_) finish(now);
    ++sum_.scans;
    sum_.end = now;
    if (scan.report.status == LocalizationStatus::kOk) ++sum_.ok;
    sum_.mean_time += scan.seconds;
    sum_.max_time = std::max(sum_.max_time, scan.seconds);
    if (scan.seconds > scan_period_) ++sum_.late;
    if (!scan.report.map_T_base) return;
    const Pose2 error = scan.world_T_base.inverse() * scan.report.map_T_base->pose;
    ++sum_.posed;
    sum_.position_rmse += error.translation().squaredNorm();
    sum_.position_max = std::max(sum_.position_max, error.translation().norm());
    sum_.heading_rmse += error.theta() * error.theta();
  }

  void add(const HaltingPoint& point) {
    if (point.halt.after_curve) return;
    const double distance =
        (point.world_T_base.translation() - point.halt.map_T_planned.translation()).norm();
    ++sum_.halts;
    sum_.halt_mean += distance;
    sum_.halt_max = std::max(sum_.halt_max, distance);
  }

  void finish(double now) {
    const auto mean = [](double sum, std::size_t count) {
      return sum / static_cast<double>(std::max<std::size_t>(1, count));
    };
    sum_.mean_time = mean(sum_.mean_time, sum_.scans);
    sum_.position_rmse = std::sqrt(mean(sum_.position_rmse, sum_.posed));
    sum_.heading_rmse = std::sqrt(mean(sum_.heading_rmse, sum_.posed));
    sum_.halt_mean = mean(sum_.halt_mean, sum_.halts);
    if (sum_.scans > 0) each_(sum_);
    sum_ = SoakPeriod();
    sum_.begin = sum_.end = now;
  }
  double end() const { return sum_.end; }

 private:
  double length_, scan_period_;
  std::function<void(const SoakPeriod&)> each_;
  std::optional<Time> start_;
  SoakPeriod sum_;
};

VehicleCalibration calibrated(const VehicleModel& vehicle, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return drawn_calibration(vehicle, CalibrationSpread(), random);
}

}  // namespace

void validate(const SoakParams& params) {
  require_in_range("hours", params.hours, 1e-3, 1e4);
  require_in_range("period_minutes", params.period_minutes, 1e-2, 1e4);
  validate(params.localizer);
  validate(params.odometry);
}

std::string soak(const Scenario& scenario, const Layout& layout, const LandmarkMap& map,
                 const SoakParams& params, const std::function<void(const SoakPeriod&)>& each) {
  validate(params);
  SoakTally tally(params, scenario.laser.scan_period, each);
  const LayoutRepetition all_day{std::numeric_limits<int>::max(), 3600.0 * params.hours};
  const LayoutDrive drive = drive_layout(
      scenario, layout, calibrated(scenario.vehicle, params.seed), params.localizer,
      params.odometry, map, params.seed, all_day, [&](const LayoutScan& scan) { tally.add(scan); },
      [&](const HaltingPoint& point) { tally.add(point); });
  tally.finish(tally.end());
  return drive.trouble;
}

}  // namespace falko_slam
