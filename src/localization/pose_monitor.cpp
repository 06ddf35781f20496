// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_monitor.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/chi_square.hpp"

namespace falko_slam {
namespace {

struct Deviations {
  double position, heading;
};

Deviations deviations_of(const PoseEstimate& pose) {
  const Eigen::Matrix3d& P = pose.covariance;
  const double greatest =
      0.5 * (P(0, 0) + P(1, 1)) + std::hypot(0.5 * (P(0, 0) - P(1, 1)), P(0, 1));
  return {std::sqrt(std::max(0.0, greatest)), std::sqrt(std::max(0.0, P(2, 2)))};
}

bool older(Time now, Time then, double seconds) { return now - then > from_seconds(seconds); }

}  // namespace

PoseMonitor::PoseMonitor(const PoseMonitorParams& params) : params_(params) { validate(params_); }

void PoseMonitor::begin(Time now, double evidence) {
  window_.clear();
  evidence_ = std::clamp(evidence, -params_.bound, params_.bound);
  agreed_ = 0;
  last_scan_ = last_motion_ = now;
  disagreed_.reset();
  set_back_.reset();
  changed_.reset();
}

void PoseMonitor::scene_changed(Time stamp) {
  window_.clear();
  evidence_ = std::min(evidence_, 0.0);
  agreed_ = 0;
  if (!changed_) changed_ = stamp;
}

void PoseMonitor::clock_set_back(Time stamp) {
  window_.clear();
  agreed_ = 0;
  last_scan_ = last_motion_ = stamp;
  disagreed_.reset();
  set_back_ = stamp;
}

void PoseMonitor::add(Time stamp, const ScanEvidence& scan) {
  evidence_ = std::clamp(evidence_ + scan.log_odds, -params_.bound, params_.bound);
  if (scan.agreement.used > 0 && scan.log_odds > 0.0) ++agreed_;
  if (agreed_ >= params_.confirmations) {
    set_back_.reset();
    changed_.reset();
  }
  last_scan_ = std::max(last_scan_, stamp);
  window_.push_back({stamp, scan.agreement});
  while (!window_.empty() && older(last_scan_, window_.front().stamp, params_.window)) {
    window_.pop_front();
  }
}

PoseVerdict PoseMonitor::judge(Time now, const PoseEstimate& pose) const {
  const Deviations deviation = deviations_of(pose);
  if (changed_ && older(now, *changed_, params_.carried_patience)) {
    return {LocalizationStatus::kLost, LocalizationReason::kCarried};
  }
  if (evidence_ <= params_.lost_evidence) {
    return {LocalizationStatus::kLost, LocalizationReason::kContradicted};
  }
  if (!(deviation.position < params_.lost_position && deviation.heading < params_.lost_heading)) {
    return {LocalizationStatus::kLost, LocalizationReason::kTooUncertain};
  }
  if (older(now, std::max(last_scan_, last_motion_), params_.lost_silence)) {
    return {LocalizationStatus::kLost, LocalizationReason::kNoSensors};
  }
  const LocalizationReason reason = trouble(now, pose);
  const bool ok = reason == LocalizationReason::kNone;
  return {ok ? LocalizationStatus::kOk : LocalizationStatus::kDegraded, reason};
}

// In the order of LocalizationReason.
LocalizationReason PoseMonitor::trouble(Time now, const PoseEstimate& pose) const {
  const Deviations deviation = deviations_of(pose);
  if (set_back_) return LocalizationReason::kClockSetBack;
  if (older(now, last_motion_, params_.motion_silence)) return LocalizationReason::kNoMotions;
  if (disagreed_ && !older(now, *disagreed_, params_.window)) {
    return LocalizationReason::kOdometryDisagrees;
  }
  if (older(now, last_scan_, params_.scan_silence)) return LocalizationReason::kNoScans;
  if (agreed_ < params_.confirmations || evidence_ < params_.ok_evidence) {
    return LocalizationReason::kUnconfirmed;
  }
  const LocalizationReason of_window = trouble_of_window(now);
  if (of_window != LocalizationReason::kNone) return of_window;
  if (deviation.position > params_.ok_position || deviation.heading > params_.ok_heading) {
    return LocalizationReason::kUncertain;
  }
  return LocalizationReason::kNone;
}

LocalizationReason PoseMonitor::trouble_of_window(Time now) const {
  MapAgreement sum;
  std::size_t scans = 0;
  for (const auto& [stamp, scan] : window_) {
    if (older(now, stamp, params_.window)) continue;
    ++scans;
    sum.used += scan.used;
    sum.in_state += scan.in_state;
    sum.strangers += scan.strangers;
    sum.expected += scan.expected;
    sum.missed += scan.missed;
    sum.nis += scan.nis;
    sum.degrees_of_freedom += scan.degrees_of_freedom;
  }
  if (chi_square_tail(sum.nis, sum.degrees_of_freedom) < params_.misfit_tail) {
    return LocalizationReason::kMisfit;
  }
  const auto share = [](std::size_t good, std::size_t bad) {
    return good + bad == 0 ? 1.0 : static_cast<double>(good) / static_cast<double>(good + bad);
  };
  if (share(sum.used, sum.strangers) < params_.min_share ||
      share(sum.expected - sum.missed, sum.missed) < params_.min_share) {
    return LocalizationReason::kMapDisagrees;
  }
  if (static_cast<double>(sum.used + sum.in_state) <
      params_.min_landmarks * static_cast<double>(scans)) {
    return LocalizationReason::kFewLandmarks;
  }
  return LocalizationReason::kNone;
}

}  // namespace falko_slam
