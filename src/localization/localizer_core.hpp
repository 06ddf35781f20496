// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/localization/localizer.hpp"
#include "falko_slam/localization/odometry_track.hpp"
#include "falko_slam/localization/pose_filter.hpp"
#include "falko_slam/localization/pose_hypotheses.hpp"
#include "falko_slam/localization/pose_monitor.hpp"
#include "falko_slam/localization/scan_landmarks.hpp"
#include "falko_slam/localization/scene_memory.hpp"

namespace falko_slam {

class Localizer::Impl {
 public:
  Impl(const LocalizerParams& params, const LandmarkMap& map);

  InputVerdict add_motion(Time stamp, const PoseEstimate& motion);
  void add_landmarks(const ScanLandmarks& landmarks, const ScanSight* sight);
  void add_scan(const LaserScan& scan);
  void set_pose(Time stamp, const std::optional<PoseEstimate>& map_T_base);
  void forget_pose(bool search);
  void check(Time now);
  std::vector<ActiveLandmark> landmarks() const;

  LocalizerParams params_;
  LocalizerReport report_;

 private:
  using Observations = std::vector<LandmarkObservation>;

  bool clock_went_back(Time stamp);
  void restart_clock(Time stamp);
  void bridge_silence(Time until);
  PoseEstimate without_bridged(Time stamp, const PoseEstimate& motion);

  void restart_at(Time stamp, const PoseEstimate& map_T_base);
  LandmarkFilterParams landmark_params() const;
  PoseEstimate prior_at(Time instant) const;
  ScanLandmarks telling(const ScanLandmarks& landmarks) const;
  bool let_it_slip(const ScanLandmarks& all, const PoseEstimate& prior, Observations& observations);
  bool within_reach(const Pose2& from, const Pose2& to, double time) const;
  void track_scan(const ScanLandmarks& landmarks, Observations observations,
                  const ScanSight* sight);
  void search_scan(const ScanLandmarks& landmarks, const ScanSight* sight);
  std::optional<PoseHypothesis> decided() const;
  void forget_places();
  void report_seen(const Observations& observations, const PoseUpdate* update);
  void judge();

  std::shared_ptr<const LandmarkIndex> index_;
  LandmarkMap telling_map_;  // what decides where the vehicle is
  std::shared_ptr<const LandmarkIndex> telling_index_;
  PoseFilterParams filter_params_;
  LandmarkDetector detector_;
  PoseEvidence evidence_, telling_evidence_, corner_evidence_;
  PoseMonitor monitor_;
  PoseHypotheses hypotheses_;
  std::optional<PoseHypotheses> with_corners_;  // where the map has both and they shall decide
  OdometryTrack track_;
  SceneMemory scene_;
  std::optional<PoseHistory> history_;  // while there is a pose
  bool searching_ = false;
  Time latest_{};                     // of all stamps
  Time searched_{};                   // where the hypotheses are
  Time fitted_{};                     // last scan that agreed
  std::optional<Time> bridged_from_;  // last true motion, while motions are made up
  int set_back_ = 0;                  // motions in a row that are older than the track
  Time set_back_stamp_{};
};

}  // namespace falko_slam
