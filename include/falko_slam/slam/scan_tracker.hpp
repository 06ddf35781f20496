// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/matching/two_point_matcher.hpp"
#include "falko_slam/place_recognition/keyframe.hpp"
#include "falko_slam/place_recognition/scan_agreement.hpp"
#include "falko_slam/place_recognition/scan_registration.hpp"

namespace falko_slam {

struct ScanTrackerParams {
  /// A scan becomes a keyframe if the laser has moved this far from the last one, or turned by this
  /// much. [0.01, 100] [m], [0.01, pi] [rad]
  double min_step = 0.5;
  double min_turn = 0.5;
  /// Keyframes that make up the local map, the last ones. [1, 100]
  int local_keyframes = 3;
  /// Standard deviation of a step of the odometry, and of a step that only goes on as before where
  /// there is none: so much, and a share of the step. Scans correct it wherever they can tell.
  /// [1e-4, 10] [m], [rad]; [0, 10] []
  double odometry_distance = 0.02;
  double odometry_turn = 0.02;
  double odometry_share = 0.2;
  double free_distance = 0.1;
  double free_turn = 0.1;
  /// With less agreement of scan and local map other starts are tried; with less than the second,
  /// or below a tenth of a view in common, the scan is lost. [0, 1]
  double good_agreement = 0.7;
  double least_agreement = 0.35;
  /// Odometry that moves the laser farther from one scan to the next was reset. [0.1, 1e6] [m]
  double max_jump = 5.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanTrackerParams& params);

/// What a tracker knows of a scan.
struct TrackedScan {
  Pose2 track_T_laser;
  /// Of the pose seen from the last keyframe (covariance along the axes of that): scans and
  /// odometry together.
  PoseEstimate keyframe_T_laser;
  double agreement = 0.0;  ///< of the scan and the local map, 0 to 1
  bool lost = false;       ///< the scan fits nowhere: the pose is where odometry puts it
  bool searched = false;   ///< the prediction was no good start, others were tried
  bool keyframe = false;   ///< worth to be remembered, to be given to `keep`
};

/// Follows the laser from scan to scan: each scan is registered with a local map of the last
/// keyframes, from where odometry predicts it or, without any, from where the motion would have
/// gone on. Odometry is doubted: its step is a prior no firmer than its noise, and if the scan does
/// not fit there, other starts are tried (as before, standing still, turned, and where the
/// keypoints match).
///
/// Frame `track`: the laser's first pose is the odometry's, or identity; from there on it drifts in
/// its own way, always less than odometry where the scans can tell. Not thread-safe.
class ScanTracker {
 public:
  explicit ScanTracker(const ScanTrackerParams& params = {}, const KeyframeParams& keyframe = {},
                       const AgreementParams& agreement = {});

  /// For each scan in turn.
  TrackedScan track(const LaserScan& scan, Time stamp, const std::optional<Pose2>& odom_T_laser);
  /// Makes this scan, the one of the last call to `track`, the newest keyframe of the local map.
  void keep(const LaserScan& scan);
  /// What comes next has nothing to do with what was before.
  void reset();

  const ScanTrackerParams& params() const { return params_; }

 private:
  struct Local {
    LaserScan scan;
    ScanView view;
    Pose2 track_T_laser;
  };
  // Covariances are those of x, y and theta in the track frame, relative to the newest keyframe.
  struct Last {
    Pose2 track_T_laser;
    Eigen::Matrix3d covariance;
    std::optional<Pose2> odom_T_laser;
    Time stamp;
    Pose2 step;  // to there from the scan before
  };
  struct Prediction {
    Pose2 step;
    Pose2 pose;
    Eigen::Matrix3d covariance;
    double gap;  // since the scan before [s]
  };
  struct Fit {
    Pose2 pose;
    Eigen::Matrix3d information;  // from the scans
    double agreement;
  };

  Prediction predict(Time stamp, const std::optional<Pose2>& odom_T_laser) const;
  TrackedScan begin(const LaserScan& scan, Time stamp, const std::optional<Pose2>& odom_T_laser);
  std::optional<Fit> fit(const ScanView& view, const Pose2& start,
                         const Eigen::Matrix3d& prior) const;
  double agreement_at(const ScanView& view, const Pose2& pose) const;
  std::vector<Pose2> other_starts(const LaserScan& scan, const Pose2& step);
  Fit search(const LaserScan& scan, const ScanView& view, const Prediction& prediction, Fit best);
  bool far_from_keyframe(const Pose2& pose) const;

  ScanTrackerParams params_;
  RegistrationParams registration_;
  AgreementParams agreement_;
  KeyframeBuilder builder_;
  ScanViewParams source_view_;  // of scans that are tracked
  TwoPointMatcher matcher_;
  std::deque<Local> local_;  // the newest at the end
  std::optional<Last> last_;
};

}  // namespace falko_slam
