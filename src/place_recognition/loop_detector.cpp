// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/loop_detector.hpp"

#include <algorithm>
#include <utility>

#include "loop_memory.hpp"

namespace falko_slam {

const LoopCandidate* LoopDetection::accepted() const {
  const auto found = std::find_if(
      candidates.begin(), candidates.end(),
      [](const LoopCandidate& candidate) { return candidate.verdict == LoopVerdict::kAccepted; });
  return found != candidates.end() ? &*found : nullptr;
}

LoopDetector::LoopDetector(const LoopDetectorParams& params)
    : memory_((validate(params), std::make_unique<Memory>(params))) {}
LoopDetector::~LoopDetector() = default;
LoopDetector::LoopDetector(LoopDetector&&) noexcept = default;
LoopDetector& LoopDetector::operator=(LoopDetector&&) noexcept = default;

const LoopDetectorParams& LoopDetector::params() const { return memory_->params; }
const std::vector<Keyframe>& LoopDetector::keyframes() const { return memory_->keyframes; }

KeyframeId LoopDetector::add(const LaserScan& scan, const Pose2& odom_T_laser) {
  Keyframe keyframe = memory_->builder.build(scan);
  keyframe.id = {memory_->keyframes.size()};
  keyframe.odom_T_laser = odom_T_laser;
  if (memory_->new_drive) memory_->odometry.reset();
  keyframe.mended_T_laser = memory_->odometry.add(keyframe.view, odom_T_laser);
  if (!memory_->keyframes.empty()) {
    const Keyframe& last = memory_->keyframes.back();
    keyframe.drive = last.drive + (memory_->new_drive ? 1U : 0U);
    const Eigen::Vector2d step = odom_T_laser.translation() - last.odom_T_laser.translation();
    if (!memory_->new_drive) keyframe.path = last.path + step.norm();
  }
  memory_->new_drive = false;
  if (!keyframe.signature.empty()) memory_->index.add(keyframe.id, keyframe.signature);
  memory_->targets.emplace_back(keyframe.points, memory_->params.matcher);
  memory_->keyframes.push_back(std::move(keyframe));
  return memory_->keyframes.back().id;
}

void LoopDetector::begin_drive() { memory_->new_drive = !memory_->keyframes.empty(); }

LoopDetection LoopDetector::detect(KeyframeId id, const Admission& admits,
                                   const PoseAdmission& possible) {
  const Keyframe& source = memory_->at(id);
  const auto admitted = [&](const Keyframe& target) {
    if (target.id == id) return false;
    if (admits) return admits(target);
    if (target.id.value > id.value) return false;
    return target.drive != source.drive || source.path - target.path >= memory_->params.min_path;
  };
  LoopDetection detection{memory_->match(source, admitted)};
  memory_->possible = possible;
  memory_->drop_impossible(detection.candidates);
  memory_->verify_first(source, detection.candidates);
  memory_->compare_first(source, detection.candidates);
  if (!detection.candidates.empty()) {
    LoopVerdict& best = detection.candidates.front().verdict;
    if (best == LoopVerdict::kNotBest) {
      best = memory_->ambiguous(source, detection.candidates) ? LoopVerdict::kAmbiguous
                                                              : LoopVerdict::kAccepted;
    }
  }
  return detection;
}

std::vector<LoopCandidate> LoopDetector::locate(const LaserScan& scan, std::size_t count,
                                                const Admission& admits) {
  const Keyframe source = memory_->builder.build(scan);
  auto candidates =
      memory_->match(source, [&](const Keyframe& target) { return !admits || admits(target); });
  memory_->verify_first(source, candidates);
  const auto end =
      std::remove_if(candidates.begin(), candidates.end(),
                     [](const LoopCandidate& candidate) { return candidate.scan_score <= 0.0; });
  candidates.erase(end, candidates.end());
  for (LoopCandidate& candidate : candidates) candidate.score = candidate.scan_score;
  if (candidates.size() > count) candidates.resize(count);
  return candidates;
}

}  // namespace falko_slam
