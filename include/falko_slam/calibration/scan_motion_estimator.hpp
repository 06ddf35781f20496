// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/mean_scan.hpp"
#include "falko_slam/calibration/wall_registration.hpp"
#include "falko_slam/place_recognition/scan_agreement.hpp"
#include "falko_slam/place_recognition/scan_registration.hpp"
#include "falko_slam/sensor/deskew.hpp"

namespace falko_slam {

struct ScanMotionParams {
  WallScanParams walls;
  WallRegistrationParams registration;
  /// Standard deviation of a range [m], (0, 1]; the scans at rest may tell that it is more.
  double range_noise = 0.01;
  /// The encoders' motion is off by this share of it, [0.001, 1].
  double odometry_share = 0.05;
  /// Scans on the way are remembered this far from each other [m], [rad]. [0.01, 100], [0.01, pi]
  double key_step = 1.0;
  double key_turn = 0.4;
  std::size_t min_parts = 5;   ///< of walls, seen at both ends, [3, 1000]
  double min_agreement = 0.6;  ///< share of the walls in view at both ends that agree, [0, 1]
  /// A pose whose standard deviation is greater in any direction is not determined [m], [rad].
  /// [1e-6, 10], [1e-6, 1]
  double max_deviation = 0.03;
  double max_turn_deviation = 0.005;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanMotionParams& params);

/// The motion of a laser from one halt to the next.
struct ScanMotion {
  PoseEstimate start_T_end;
  double turn = 0.0;  ///< with its whole turns [rad]
  /// What of the covariance does not average out, WallRegistrationParams::lasting_noise.
  Eigen::Matrix3d lasting_covariance = Eigen::Matrix3d::Zero();
  double rms_residual = 0.0;  ///< of the walls at both ends [m]
  std::size_t parts = 0;      ///< of walls seen at both ends of the last link
  std::size_t links = 1;      ///< registrations in a row; 1: the end with the start itself
  std::size_t scans = 0;      ///< in all
};

/// Finds out how a laser moved from what it saw of the walls: at rest, on the way, at rest again.
/// The twin of ReflectorMotionEstimator where there are no reflectors.
///
/// The scans of a halt are averaged beam by beam. On the way each scan, freed from its motion, is
/// registered with the one at the start and the last ones that were remembered, only so that the
/// end is known nearly. The motion itself is the registration of the walls at the end with those
/// at the start, register_walls(), once. Where both ends see little alike the way leads over scans
/// that were remembered: that of least variance, where each link adds its own, and each scan on the
/// way what the encoders' motion may have bent it by. What the scans leave open stays open: the
/// encoders are what is to be calibrated, and say nothing of the result. Not thread-safe.
class ScanMotionEstimator {
 public:
  explicit ScanMotionEstimator(const ScanMotionParams& params = {});

  /// A scan while the vehicle stands before it starts.
  void add_at_start(const LaserScan& scan);
  /// A scan on the way, as it was taken; `step` is the laser's motion since the scan before, from
  /// first beam to first beam, `sweep` that while it was taken, both by the encoders.
  void add_on_the_way(const LaserScan& scan, const Pose2& step, const LaserMotion& sweep);
  /// A scan while the vehicle stands at the end; `step` only counts for the first one.
  void add_at_end(const LaserScan& scan, const Pose2& step = {});

  /// Empty, with a `complaint()`, if the walls do not tell.
  std::optional<ScanMotion> result();
  const std::string& complaint() const { return complaint_; }
  /// Scans on the way that fitted nowhere: there the encoders alone led on.
  std::size_t lost_scans() const { return lost_scans_; }

 private:
  /// A scan that others are compared with.
  struct Key {
    ScanView view;
    WallScan walls;
    Pose2 start_T_laser;                             // as it was tracked
    Eigen::Matrix3d bent = Eigen::Matrix3d::Zero();  // covariance of what its sweep may feign
  };
  /// The best way that is known from the start.
  struct Reached {
    PoseEstimate start_T_laser;
    Eigen::Matrix3d lasting = Eigen::Matrix3d::Zero();
    WallRegistration last;
    std::size_t links = 0;
  };

  void begin();
  void move(const Pose2& step);
  bool track(const ScanView& view);
  Key key_of(const LaserScan& scan, double noise, const Pose2& start_T_laser) const;
  Eigen::Matrix3d bend_of(const LaserScan& scan, const LaserMotion& sweep) const;
  std::optional<WallRegistration> link(const Key& from, const Key& to) const;
  std::vector<std::optional<Reached>> reach(const Key& end) const;
  std::optional<Reached> with_start(const Reached& end, const Key& key) const;
  std::optional<ScanMotion> refuse(const std::string& complaint);

  ScanMotionParams params_;
  RegistrationParams tracking_;
  std::vector<LaserScan> at_start_, at_end_;
  std::vector<Key> keys_;  // the start, then those on the way
  double noise_ = 0.0;     // of a range of one scan
  Pose2 start_T_laser_;
  Pose2 untracked_;  // motion since a scan was registered
  double turn_ = 0.0;
  std::size_t scans_ = 0, lost_scans_ = 0;
  std::string complaint_;
};

}  // namespace falko_slam
