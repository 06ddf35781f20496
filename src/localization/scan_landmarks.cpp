// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scan_landmarks.hpp"

#include <algorithm>

#include "falko_slam/sensor/deskew.hpp"

namespace falko_slam {
namespace {

bool holds(const LandmarkMap& map, LandmarkKind kind) {
  return std::any_of(map.landmarks.begin(), map.landmarks.end(),
                     [kind](const MapLandmark& landmark) { return landmark.kind == kind; });
}

// Filters do not know kinds: such a corner would claim the reflector's place.
constexpr double kBesideReflector = 0.3;  // [m]

bool is_beside_reflector(const Eigen::Vector2d& corner, const std::vector<TimedObservation>& seen) {
  return std::any_of(seen.begin(), seen.end(), [&](const TimedObservation& other) {
    return other.kind == LandmarkKind::kReflector &&
           (other.observation.value - corner).norm() < kBesideReflector;
  });
}

Time middle_of(const LaserScan& scan) {
  if (scan.size() == 0) return scan.first_beam_time;
  return scan.first_beam_time + scan.time_increment * static_cast<Duration::rep>(scan.size()) / 2;
}

}  // namespace

LandmarkDetector::LandmarkDetector(const LocalizerParams& params, const LandmarkMap& map)
    : base_T_laser_(params.base_T_laser),
      deskew_(params.deskew),
      features_(params.features),
      reflectors_wanted_(holds(map, LandmarkKind::kReflector)),
      corners_wanted_(holds(map, LandmarkKind::kFeature)),
      reflectors_(params.reflectors),
      corners_(params.features.falko) {}

ScanLandmarks LandmarkDetector::detect(const LaserScan& scan, const OdometryTrack& track) {
  ScanLandmarks result;
  result.instant = middle_of(scan);
  if (scan.size() == 0) return result;
  if (reflectors_wanted_) add_reflectors(scan, track, result);
  if (corners_wanted_) add_corners(scan, track, result);
  return result;
}

Pose2 LandmarkDetector::odom_T_laser(const OdometryTrack& track, Time time) const {
  return track.at(time) * base_T_laser_;
}

void LandmarkDetector::add_reflectors(const LaserScan& scan, const OdometryTrack& track,
                                      ScanLandmarks& result) {
  result.report = reflectors_.detect(scan, found_);
  const Pose2 laser_T_odom = odom_T_laser(track, result.instant).inverse();
  for (const DetectedReflector& reflector : found_) {
    PointEstimate seen{reflector.center, reflector.covariance};
    if (deskew_) {
      const Pose2 moved = laser_T_odom * odom_T_laser(track, reflector.time);
      seen = transform({moved, Eigen::Matrix3d::Zero()}, seen);
    }
    const LandmarkObservation observation{
        ObservationModel::kCartesian, seen.point, seen.covariance, {}};
    if (!is_usable(observation)) continue;
    result.seen.push_back({observation, LandmarkKind::kReflector, result.instant - reflector.time});
  }
}

void LandmarkDetector::add_corners(const LaserScan& scan, const OdometryTrack& track,
                                   ScanLandmarks& result) {
  const Duration sweep =
      std::chrono::abs(scan.time_increment) * static_cast<Duration::rep>(scan.size());
  const Time begin = std::min(scan.first_beam_time, scan.beam_time(scan.size() - 1));
  const Pose2 begin_T_end =
      odom_T_laser(track, begin).inverse() * odom_T_laser(track, begin + sweep);
  if (deskew_) {
    corners_.detect(falko_slam::deskew(scan, {begin_T_end, sweep}, result.instant), keypoints_);
  } else {
    corners_.detect(scan, keypoints_);
  }
  const Eigen::Matrix2d covariance =
      features_.position_noise * features_.position_noise * Eigen::Matrix2d::Identity();
  for (const Keypoint& keypoint : keypoints_) {
    if (!(keypoint.position.norm() <= features_.max_range)) continue;
    if (is_beside_reflector(keypoint.position, result.seen)) continue;
    result.seen.push_back({{ObservationModel::kCartesian, keypoint.position, covariance, {}},
                           LandmarkKind::kFeature,
                           result.instant - scan.beam_time(keypoint.beam)});
  }
}

}  // namespace falko_slam
