// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/mean_scan.hpp"
#include "falko_slam/calibration/scan_motion.hpp"
#include "falko_slam/place_recognition/scan_registration.hpp"
#include "falko_slam/sensor/deskew.hpp"

namespace falko_slam {

/// Finds out how a laser moved from what it saw of the walls: at rest, on the way, at rest again.
/// The twin of ReflectorMotionEstimator where there are no reflectors.
///
/// The scans of a halt are averaged beam by beam. On the way each scan, freed from its motion, is
/// registered with the one at the start and the last ones that were remembered, only so that the
/// end is known nearly. The motion itself is the registration of the walls at the end with those
/// at the start, register_walls(), once. Where both ends see little alike the way leads over scans
/// that were remembered: that of least variance, where each link adds its own, and each scan on the
/// way what its own motion may have bent it by. What the scans leave open stays open: the encoders
/// are what is to be calibrated, and say nothing of the result. Not thread-safe.
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
  /// A scan that the next ones are laid over.
  struct Key {
    LaserScan scan;  // as it was taken
    LaserMotion sweep;
    ScanView view;
    Pose2 start_T_laser;
  };

  void begin();
  void move(const Pose2& step);
  bool track(const ScanView& view);
  std::vector<PosedView> local_map() const;
  double mended_turn() const;
  WallScan walls_of(const MeanScan& mean) const;
  std::optional<ScanMotion> refuse(const std::string& complaint);

  ScanMotionParams params_;
  ScanViewParams view_;
  RegistrationParams tracking_;
  std::vector<LaserScan> at_start_, at_end_;
  MeanScan start_;
  std::vector<Key> keys_;  // the start, then those on the way
  Pose2 start_T_laser_;
  Pose2 untracked_;  // motion since a scan was registered
  double turn_ = 0.0, turn_of_encoders_ = 0.0;
  std::size_t scans_ = 0, lost_scans_ = 0;
  std::string complaint_;
};

}  // namespace falko_slam
