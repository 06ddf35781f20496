// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"

namespace falko_slam {

void validate(const LoopDetectorParams& params) {
  validate(params.keyframe);
  validate(params.matcher);
  validate(params.agreement);
  validate(params.registration);
  validate(params.odometry);
  require_in_range("candidates", params.candidates, 1, 1000);
  require_in_range("verified", params.verified, 1, 1000);
  require_in_range("compared", params.compared, 1, 100);
  require_in_range("neighborhood", params.neighborhood, 0.1, 100.0);
  require_in_range("neighbor_spacing", params.neighbor_spacing, 0.0, 100.0);
  require_in_range("max_neighbors", params.max_neighbors, 1, 100);
  require_in_range("neighbor_tolerance", params.neighbor_tolerance, 1e-3, 10.0);
  require_in_range("min_path", params.min_path, 0.0, 1e6);
  require_in_range("min_score", params.min_score, 0.0, 1.0);
  require_in_range("ambiguity", params.ambiguity, 0.0, 1.0);
  require_in_range("contradicting_distance", params.contradicting_distance, 0.0, 100.0);
  require_in_range("contradicting_turn", params.contradicting_turn, 0.0, kPi);
  require_in_range("drift", params.drift, 0.0, 1.0);
  require_in_range("turn_drift", params.turn_drift, 0.0, 1.0);
}

const char* name_of(LoopVerdict verdict) {
  switch (verdict) {
    case LoopVerdict::kNotMatched:
      return "keypoints do not match";
    case LoopVerdict::kFewerPairs:
      return "fewer matching keypoints than others";
    case LoopVerdict::kDisagrees:
      return "scans disagree";
    case LoopVerdict::kNotRegistered:
      return "scans cannot be aligned";
    case LoopVerdict::kMovedAway:
      return "alignment moved away from the keypoints";
    case LoopVerdict::kLowScore:
      return "score too low";
    case LoopVerdict::kAmbiguous:
      return "a contradicting place is nearly as good";
    case LoopVerdict::kNotBest:
      return "another candidate is better";
    case LoopVerdict::kAccepted:
      return "accepted";
  }
  return "unknown";
}

}  // namespace falko_slam
