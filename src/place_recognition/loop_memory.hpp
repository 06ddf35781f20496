// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/place_recognition/loop_detector.hpp"
#include "falko_slam/place_recognition/signature_index.hpp"

namespace falko_slam {

/// The keyframes of a LoopDetector, and the steps from a source keyframe to its loop.
struct LoopDetector::Memory {
  explicit Memory(const LoopDetectorParams& params);

  LoopDetectorParams params;
  KeyframeBuilder builder;
  TwoPointMatcher matcher;        // one pose for each candidate
  TwoPointMatcher rival_matcher;  // several for the best one
  SignatureIndex index;
  std::vector<Keyframe> keyframes;
  std::vector<TwoPointTarget> targets;  // their points
  ScanOdometry odometry;
  bool new_drive = false;  // the next keyframe begins one
  PoseAdmission possible;  // of the detection under way

  const Keyframe& at(KeyframeId id) const { return keyframes.at(id.value); }

  /// The keyframes with the nearest signatures and the poses that their keypoints give, those with
  /// the most pairs first.
  std::vector<LoopCandidate> match(const Keyframe& source, const Admission& admits);

  /// Aligns all points, and scores. What is left to be done if it passes is kLowScore.
  LoopVerdict verify(const Keyframe& source, LoopCandidate& candidate) const;
  /// The first `verified` of them, and sorts.
  void verify_first(const Keyframe& source, std::vector<LoopCandidate>& candidates) const;

  /// The centre and the keyframes of its drive up to `end` along the way on both sides of it.
  Neighborhood neighborhood(KeyframeId center, std::size_t end) const;
  /// Scores a verified candidate by the neighbours of both sides.
  void ask_neighbors(const Keyframe& source, LoopCandidate& candidate) const;
  /// The first `compared` of those verified, as long as they can be better, and sorts.
  void compare_first(const Keyframe& source, std::vector<LoopCandidate>& candidates) const;

  bool is_possible(const LoopCandidate& candidate) const {
    return !possible || possible(at(candidate.target), candidate.target_T_source->pose);
  }
  /// Those that are matched at a pose that cannot be.
  void drop_impossible(std::vector<LoopCandidate>& candidates) const;

  /// Do two candidates put the source at different places?
  bool contradict(const LoopCandidate& a, const LoopCandidate& b) const;
  /// Verifies and scores a candidate that contradicts the best one: is it nearly as good?
  bool rivals(const Keyframe& source, LoopCandidate other, const LoopCandidate& best) const;
  /// Is there any such? Among the other candidates, by another match with the same keyframe, or
  /// with the source turned about its middle.
  bool ambiguous(const Keyframe& source, const std::vector<LoopCandidate>& candidates);
};

/// The greatest score first.
void sort_by_score(std::vector<LoopCandidate>& candidates);

}  // namespace falko_slam
