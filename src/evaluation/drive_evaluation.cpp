// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/drive_evaluation.hpp"

#include <algorithm>

namespace falko_slam {
namespace {

struct Drive {
  std::vector<PosedScan> truth;  // of the keyframes, without their scans
  std::vector<LoopDetection> detections;
};

Drive drive_through(const std::vector<DrivenScan>& scans, DrivePoses poses,
                    LoopClosureParams params) {
  if (poses == DrivePoses::kOdometry) params.detector.odometry.max_move = 0.0;
  LoopDetector detector(params.detector);
  KeyframeSelector selector(params.selector);
  Drive drive;
  for (const DrivenScan& scan : scans) {
    const Pose2& pose = poses == DrivePoses::kCorrected ? scan.map_T_laser : scan.odom_T_laser;
    const KeyframeSelector::Choice choice = selector.choose(pose);
    if (choice == KeyframeSelector::Choice::kPassOver) continue;
    if (choice == KeyframeSelector::Choice::kFirstOfNew) detector.begin_drive();
    drive.detections.push_back(detector.detect(detector.add(scan.scan, pose)));
    drive.truth.push_back({{}, scan.map_T_laser});
  }
  return drive;
}

}  // namespace

const char* name_of(DrivePoses poses) {
  switch (poses) {
    case DrivePoses::kCorrected:
      return "corrected";
    case DrivePoses::kOdometry:
      return "odometry";
    case DrivePoses::kRegistered:
      return "registered";
  }
  return "unknown";
}

DriveResult evaluate_drive(const std::vector<DrivenScan>& scans, DrivePoses poses,
                           const LoopClosureParams& params, const LoopProtocolParams& protocol) {
  const Drive drive = drive_through(scans, poses, params);
  const LoopTruth truth(drive.truth, LoopProtocol::kRevisits, protocol);
  DriveResult result;
  result.poses = poses;
  result.keyframes = drive.detections.size();
  result.loops = truth.loops();
  std::vector<LoopAnswer> answers(drive.detections.size());
  for (std::size_t source = 0; source < answers.size(); ++source) {
    LoopAnswer& answer = answers[source];
    answer.has_loop = truth.has_loop(source);
    const auto& candidates = drive.detections[source].candidates;
    if (candidates.empty() || candidates.front().score <= 0.0) continue;
    const LoopCandidate& best = candidates.front();
    answer.right = truth.is_right(source, static_cast<std::size_t>(best.target.value),
                                  best.target_T_source->pose);
    answer.score = best.score;
    answer.closed = best.verdict == LoopVerdict::kAccepted;
    result.ambiguous += best.verdict == LoopVerdict::kAmbiguous ? 1U : 0U;
    if (!answer.closed && !answer.right) {
      result.surest_refused = std::max(result.surest_refused, best.score);
    }
  }
  result.accepted = operating_point(answers, params.detector.min_score);
  return result;
}

}  // namespace falko_slam
