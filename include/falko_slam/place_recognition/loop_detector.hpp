// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/matching/two_point_matcher.hpp"
#include "falko_slam/place_recognition/keyframe.hpp"
#include "falko_slam/place_recognition/loop_scores.hpp"
#include "falko_slam/place_recognition/scan_odometry.hpp"
#include "falko_slam/place_recognition/scan_registration.hpp"

namespace falko_slam {

struct LoopDetectorParams {
  KeyframeParams keyframe;
  TwoPointMatcherParams matcher;
  AgreementParams agreement;
  RegistrationParams registration;
  ScanOdometryParams odometry;
  /// Keyframes with the nearest signatures that are matched. Greater values find more and cost
  /// more. [1, 1000]
  int candidates = 40;
  /// Matches with the most pairs that are verified on all points. [1, 1000]
  int verified = 8;
  /// Fits that are checked against the neighbours of both keyframes. [1, 100]
  int compared = 3;
  /// Neighbours are the keyframes within this length of way on either side, at least
  /// neighbor_spacing apart, at most max_neighbors on each side; without any no loop is accepted.
  /// [0.1, 100] [m], [0, 100] [m], [1, 100]
  double neighborhood = 3.0;
  double neighbor_spacing = 0.5;
  int max_neighbors = 6;
  /// As AgreementParams::tolerance, greater by what odometry errs within the neighbourhood.
  /// [0.001, 10] [m]
  double neighbor_tolerance = 0.15;
  /// Keyframes of the same drive less than this length of way back are no loops. [m]
  double min_path = 10.0;
  /// Loops with at least this score are accepted. Greater: fewer false ones, and fewer. [0, 1]
  double min_score = 0.45;
  /// The best loop is refused if a contradicting one has at least this share of its score: another
  /// pose to the same keyframe, or to another one that puts the source elsewhere. [0, 1]
  double ambiguity = 0.4;
  /// Places contradict each other if they differ by more than this, and by more than the odometry
  /// may have drifted on the way between their keyframes: by a share of it, and by a turn per
  /// metre, which moves things by half of the turn times the way. [m], [rad], [], [rad/m]
  double contradicting_distance = 0.5;
  double contradicting_turn = 0.35;
  double drift = 0.05;
  double turn_drift = 0.01;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LoopDetectorParams& params);

/// What became of a candidate, in the order of the tests.
enum class LoopVerdict {
  kNotMatched,     ///< too few keypoints fit, or less than half as many as with another one
  kFewerPairs,     ///< than `verified` others: not looked at further
  kDisagrees,      ///< points of one scan are not where the other saw walls
  kNotRegistered,  ///< too few points to align, or a direction is open
  kMovedAway,      ///< alignment ended far from where the keypoints had put it
  kLowScore,       ///< below `min_score`
  kAmbiguous,      ///< best, but a contradicting place is nearly as good
  kNotBest,        ///< good, but another candidate is better
  kAccepted,
};
const char* name_of(LoopVerdict verdict);

struct LoopCandidate {
  KeyframeId target;
  LoopVerdict verdict = LoopVerdict::kNotMatched;
  std::uint32_t signature_distance = 0;
  std::size_t pairs = 0;      ///< of keypoints
  double scan_score = 0.0;    ///< see scan_score()
  double score = 0.0;         ///< see neighborhood_score()
  double rms_residual = 0.0;  ///< of the alignment [m]
  /// From the keypoints, then from all points; empty if there was no match.
  std::optional<PoseEstimate> target_T_source;
};

struct LoopDetection {
  /// All that were looked at, the best first.
  std::vector<LoopCandidate> candidates;

  /// Null if none is.
  const LoopCandidate* accepted() const;
};

/// Recognises places in the scans of a drive: signature, matching of keypoints, alignment and
/// agreement of all points, agreement of the scans before and after. Every candidate ends accepted
/// or with the reason why not; at most one is accepted.
///
/// Keyframes are numbered in the order in which they are added. Their poses need to be right over
/// the neighbourhood only, and each step is mended by registration with the keyframe before. A
/// drive is what one odometry connects: poses and lengths of way are never compared between drives,
/// and keyframes of different drives may be loops however short the way. Not thread-safe.
class LoopDetector {
 public:
  explicit LoopDetector(const LoopDetectorParams& params = {});
  ~LoopDetector();
  LoopDetector(LoopDetector&&) noexcept;
  LoopDetector& operator=(LoopDetector&&) noexcept;

  KeyframeId add(const LaserScan& scan, const Pose2& odom_T_laser);
  /// The odometry of the keyframes to come has nothing to do with that of those before.
  void begin_drive();
  const std::vector<Keyframe>& keyframes() const;

  using Admission = std::function<bool(const Keyframe& target)>;
  using PoseAdmission = std::function<bool(const Keyframe& target, const Pose2& target_T_source)>;
  /// Loops from a keyframe to those at least `min_path` back or of an earlier drive; if given, to
  /// those that `admits` lets through, which may be later ones too. What `possible` does not let
  /// through is neither a candidate nor a rival of one: who knows how far odometry may have drifted
  /// need not mistake a place for one that is too far away. Throws std::out_of_range if there is no
  /// such keyframe.
  LoopDetection detect(KeyframeId source, const Admission& admits = {},
                       const PoseAdmission& possible = {});

  /// Where among all keyframes a scan may have been taken, from this scan alone: at most `count`
  /// hypotheses, the best first, their `score` being the scan_score.
  std::vector<LoopCandidate> locate(const LaserScan& scan, std::size_t count,
                                    const Admission& admits = {});

  const LoopDetectorParams& params() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace falko_slam
