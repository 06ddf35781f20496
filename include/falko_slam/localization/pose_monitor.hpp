// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/localization_status.hpp"
#include "falko_slam/localization/localizer_params.hpp"
#include "falko_slam/localization/pose_evidence.hpp"

namespace falko_slam {

/// What a pose that is being tracked is worth.
using PoseVerdict = std::pair<LocalizationStatus, LocalizationReason>;

/// Sums up what scans say of a pose that is being tracked. The log odds of PoseEvidence are added
/// and held within bounds: a sequential test (\cite wald1945) that old scans do not decide.
///
/// kLost is for evidence against the pose or a covariance that says nothing; kOk for evidence, a
/// covariance, residuals and a share of the map that are all good. All else is kDegraded.
class PoseMonitor {
 public:
  explicit PoseMonitor(const PoseMonitorParams& params);

  /// A new pose, of which scans must be seen before it is kOk.
  void begin(Time now, double evidence);

  /// A scan with its evidence.
  void add(Time stamp, const ScanEvidence& evidence);
  void motion_seen(Time stamp) { last_motion_ = std::max(last_motion_, stamp); }
  /// Not kOk for the length of the window.
  void odometry_disagreed(Time stamp) { disagreed_ = stamp; }
  void clock_set_back(Time stamp);
  /// The scene changed at once: what spoke for the pose counts no more, scans must do so anew.
  void scene_changed(Time stamp);

  /// At a time not before any of these.
  PoseVerdict judge(Time now, const PoseEstimate& pose) const;

  double evidence() const { return evidence_; }

 private:
  struct Entry {
    Time stamp{};
    MapAgreement agreement;
  };
  LocalizationReason trouble(Time now, const PoseEstimate& pose) const;
  LocalizationReason trouble_of_window(Time now) const;

  PoseMonitorParams params_;
  std::deque<Entry> window_;
  double evidence_ = 0.0;
  int agreed_ = 0;  // scans since the beginning
  Time last_scan_{}, last_motion_{};
  std::optional<Time> disagreed_, set_back_, changed_;
};

}  // namespace falko_slam
