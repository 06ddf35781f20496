// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/localization/landmark.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_params.hpp"
#include "falko_slam/localization/odometry_track.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// A landmark that was seen, brought to an instant.
struct TimedObservation {
  LandmarkObservation observation;  ///< from where the laser was at the instant
  LandmarkKind kind = LandmarkKind::kReflector;
  Duration moved{};  ///< how far it was brought: the instant minus when it was seen
};

/// What a scan shows of the kinds of landmarks that a map holds.
struct ScanLandmarks {
  Time instant{};  ///< the middle of the scan
  std::vector<TimedObservation> seen;
  ReflectorReport report;  ///< of the detector of reflectors
};

/// Looks for landmarks in scans and frees them from the motion of the laser: reflectors each by the
/// time at which it was seen, corners by deskew() of the scan before. Not thread-safe.
class LandmarkDetector {
 public:
  /// Of the params those about detection. Only kinds that the map holds are looked for.
  LandmarkDetector(const LocalizerParams& params, const LandmarkMap& map);

  ScanLandmarks detect(const LaserScan& scan, const OdometryTrack& track);

 private:
  void add_reflectors(const LaserScan& scan, const OdometryTrack& track, ScanLandmarks& result);
  void add_corners(const LaserScan& scan, const OdometryTrack& track, ScanLandmarks& result);
  Pose2 odom_T_laser(const OdometryTrack& track, Time time) const;

  Pose2 base_T_laser_;
  bool deskew_;
  NaturalFeatureParams features_;
  bool reflectors_wanted_ = false, corners_wanted_ = false;
  ReflectorDetector reflectors_;
  FalkoDetector corners_;
  std::vector<DetectedReflector> found_;
  std::vector<Keypoint> keypoints_;
};

}  // namespace falko_slam
