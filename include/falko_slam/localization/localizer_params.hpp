// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/features/face_detector.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/keypoint_noise.hpp"
#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/localization/pose_history.hpp"

namespace falko_slam {

struct LandmarkMap;

/// How sure observations make us of a pose, as log odds (PoseEvidence).
struct PoseEvidenceParams {
  /// Probability that a landmark in plain sight is found. (0, 1)
  double detection = 0.8;
  /// Probability that what is found is in the map. Greater: strangers weigh more. (0, 1)
  double mapped = 0.7;
  /// Landmarks farther than this are not expected to be found. [0, 1000] [m]
  double expected_range = 15.0;
  /// What may lie between where the map has a landmark and where the scan ends, for it still to be
  /// in plain sight. [0.01, 10] [m]
  double sight_margin = 0.3;
  /// Probability that at a wrong place a corner fits to one of the map, at least: of racks that are
  /// alike many do. Counts where corners and reflectors are searched for together. (0, mapped]
  double corner_chance = 0.3;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const PoseEvidenceParams& params);

/// When a pose is kOk, kDegraded or kLost.
struct PoseMonitorParams {
  PoseEvidenceParams evidence;
  double bound = 20.0;  ///< the log odds stay within +- this: older scans do not count. [1, 1000]
  double ok_evidence = 8.0;     ///< log odds of kOk at least. [0, bound]
  double lost_evidence = -8.0;  ///< log odds of kLost at most. [-bound, 0]
  int confirmations = 3;        ///< scans that must agree before a new pose is kOk. [1, 1000]

  double window = 1.5;     ///< of what is looked at together [s], [0.1, 60]
  double min_share = 0.6;  ///< of observations that fit and of expected ones seen, for kOk. [0, 1]
  double min_landmarks = 1.5;  ///< used per scan, in the mean, for kOk. [0, 100]
  double misfit_tail = 1e-4;  ///< NIS of the window less likely than this is a misfit. [1e-12, 0.1]

  double ok_position = 0.05;   ///< standard deviation of kOk at most [m], (0, 100]
  double ok_heading = 0.02;    ///< [rad], (0, 4]
  double lost_position = 1.0;  ///< standard deviation of kLost at least [m], [ok_position, 1000]
  double lost_heading = 0.3;   ///< [rad], [ok_heading, 4]

  /// Of the points of a scan the next one shows again, at least; fewer: carried elsewhere. [0, 1]
  double min_scene = 0.7;
  double carried_patience = 1.0;  ///< for scans to show that it was not [s], [0, 60]

  double scan_silence = 0.6;    ///< without scans no longer kOk [s], [0.01, 60]
  double motion_silence = 0.3;  ///< the same of motions [s], [0.01, 60]
  double lost_silence = 10.0;   ///< without either kLost [s], [0.1, 3600]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const PoseMonitorParams& params);

/// Where in the map a scan may have been taken (ConstellationSearch).
struct ConstellationParams {
  int min_landmarks = 3;  ///< that one scan must see. [3, 100]
  double min_distance =
      1.0;            ///< between two observations that a place is made from [m], [0.1, 100]
  double gate = 3.5;  ///< of a distance in its standard deviations. [1, 10]
  int max_candidates = 20000;  ///< places that are tried; bounds the cost. [10, 10000000]
  int max_results = 12;        ///< best ones that are kept. [1, 1000]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ConstellationParams& params);

/// When one of several places is taken for the pose.
struct RecoveryParams {
  int scans = 3;              ///< that must agree with it. [1, 1000]
  double min_evidence = 8.0;  ///< log odds at least. [0, 1000]
  double margin = 6.0;        ///< log odds more than any other place's. [0, 1000]
  double drop = 15.0;       ///< places with so much less than the best are dropped. [margin, 1000]
  int memory = 50;          ///< scans that a landmark is remembered for. [0, 10000]
  int max_hypotheses = 30;  ///< carried along. [1, 1000]
  /// Where reflectors alone have not decided, those and the corners of the map do together. The
  /// pose is kDegraded until reflectors confirm it.
  bool corners = true;
  double min_share = 0.6;  ///< of all that was seen in the map, for corners to decide. [0, 1]
  /// Places that are tried in their search, as ConstellationParams::max_candidates is among
  /// reflectors. A corner has many more to be compared with. [10, 10000000]
  int corner_candidates = 5000;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const RecoveryParams& params);

/// Corners, and straight faces as landmarks of their own.
struct NaturalFeatureParams {
  /// Corners and faces that the map does not hold become landmarks of the state: they carry the
  /// pose over a way on which the map shows nothing (LandmarkFilter). Off: only what the map holds
  /// is looked for.
  bool unmapped = true;
  double max_range = 15.0;  ///< of corners; farther ones are not used [m], [0.5, 1000]
  FalkoParams falko;
  KeypointNoise corner_noise;
  FaceDetectorParams faces;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const NaturalFeatureParams& params);

struct LocalizerParams {
  Pose2 base_T_laser;
  /// Brings what a scan sees to one instant. Off: for comparison only.
  bool deskew = true;
  ReflectorDetectorParams reflectors;
  NaturalFeatureParams features;
  AssociationParams association;
  /// Of the state. Its base_T_laser and association are those of this struct, but that no search
  /// takes more steps than the smaller `max_nodes` of both.
  LandmarkFilterParams landmarks;
  PoseHistoryParams history;
  PoseMonitorParams monitor;
  ConstellationParams constellation;
  RecoveryParams recovery;
  /// Standard deviations of base_T_laser. However many scans there are, the pose does not get
  /// surer than that: what is reported has them in addition. [0, 1] [m], [0, 1] [rad]
  double mount_position = 6e-4;
  double mount_heading = 1.75e-4;
  /// Faster than this it does not move: what may have happened while the odometry was silent or
  /// wrong. [0, 100] [m/s], [0, 100] [rad/s]
  double max_speed = 2.0;
  double max_turn_rate = 1.0;
  /// Searches for the pose without being asked, when there is none or it was wrong.
  bool search_alone = true;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LocalizerParams& params);

/// Reflectors are sought by the diameter that they have on the map, whatever the parameters say:
/// of another one they are not found, or in the wrong place. Returns what is to be told of it; ""
/// if nothing changes.
std::string take_diameter_of(const LandmarkMap& map, ReflectorDetectorParams& reflectors);

}  // namespace falko_slam
