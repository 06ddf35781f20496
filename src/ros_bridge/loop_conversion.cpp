// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_conversion.hpp"

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

template <class Enum>
constexpr bool is(Enum verdict, int code) {
  return static_cast<int>(verdict) == code;
}
static_assert(is(LoopVerdict::kNotMatched, LoopConstraint::NOT_MATCHED) &&
                  is(LoopVerdict::kFewerPairs, LoopConstraint::FEWER_PAIRS) &&
                  is(LoopVerdict::kDisagrees, LoopConstraint::DISAGREES) &&
                  is(LoopVerdict::kNotRegistered, LoopConstraint::NOT_REGISTERED) &&
                  is(LoopVerdict::kMovedAway, LoopConstraint::MOVED_AWAY) &&
                  is(LoopVerdict::kLowScore, LoopConstraint::LOW_SCORE) &&
                  is(LoopVerdict::kAmbiguous, LoopConstraint::AMBIGUOUS) &&
                  is(LoopVerdict::kNotBest, LoopConstraint::NOT_BEST) &&
                  is(LoopVerdict::kAccepted, LoopConstraint::ACCEPTED),
              "the codes of the message are those of the core");

std_msgs::Header header_of(const KeyframeRecord& record, const std::string& odom_frame) {
  std_msgs::Header header;
  header.stamp = to_ros(record.stamp);
  header.frame_id = odom_frame;
  return header;
}

KeyframeScan keyframe_message(const KeyframeMemory& memory, KeyframeId id,
                              const std::string& odom_frame) {
  const KeyframeRecord& record = memory.record(id);
  KeyframeScan message;
  message.header = header_of(record, odom_frame);
  message.id = id.value;
  message.drive = static_cast<std::uint32_t>(record.drive);
  message.odom_T_keyframe = to_message(record.odom_T_laser);
  message.base_T_keyframe = to_message(record.base_T_laser);
  message.path = memory.keyframe(id).path;
  message.keypoints = static_cast<std::uint32_t>(memory.keyframe(id).points.size());
  message.scan = to_message(record.scan, record.stamp);
  return message;
}

LoopConstraint constraint_message(const KeyframeMemory& memory, KeyframeId source,
                                  const LoopCandidate& candidate) {
  LoopConstraint message;
  message.source = source.value;
  message.target = candidate.target.value;
  message.source_stamp = to_ros(memory.record(source).stamp);
  message.target_stamp = to_ros(memory.record(candidate.target).stamp);
  message.accepted = static_cast<std::uint8_t>(candidate.verdict == LoopVerdict::kAccepted);
  message.verdict = static_cast<std::uint8_t>(candidate.verdict);
  message.reason = name_of(candidate.verdict);
  message.target_T_source = to_message(*candidate.target_T_source);
  message.score = candidate.score;
  message.scan_score = candidate.scan_score;
  message.signature_distance = candidate.signature_distance;
  message.pairs = static_cast<std::uint32_t>(candidate.pairs);
  message.rms_residual = candidate.rms_residual;
  return message;
}

PoseEstimate exactly(const Pose2& pose) { return {pose, Eigen::Matrix3d::Zero()}; }

}  // namespace

KeyframeArray to_message(const KeyframeMemory& memory, KeyframeId first,
                         const std::string& odom_frame) {
  KeyframeArray message;
  message.reset = static_cast<std::uint8_t>(first.value == 0);
  message.header.frame_id = odom_frame;
  for (std::uint64_t id = first.value; id < memory.records().size(); ++id) {
    message.keyframes.push_back(keyframe_message(memory, {id}, odom_frame));
    message.header.stamp = message.keyframes.back().header.stamp;
  }
  return message;
}

LoopConstraintArray to_message(const KeyframeMemory& memory, KeyframeId source,
                               const LoopDetection& detection, const std::string& odom_frame) {
  LoopConstraintArray message;
  message.header = header_of(memory.record(source), odom_frame);
  message.source = source.value;
  for (const LoopCandidate& candidate : detection.candidates) {
    if (!candidate.target_T_source) continue;
    message.constraints.push_back(constraint_message(memory, source, candidate));
  }
  return message;
}

std::vector<PlaceHypothesis> to_messages(const KeyframeMemory& memory,
                                         const std::vector<LoopCandidate>& places,
                                         const Pose2& base_T_laser, std::size_t drive) {
  const PoseEstimate laser_T_base = exactly(base_T_laser.inverse());
  std::vector<PlaceHypothesis> messages;
  for (const LoopCandidate& place : places) {
    const KeyframeRecord& record = memory.record(place.target);
    PlaceHypothesis message;
    message.pose = to_message(
        compose(compose(exactly(record.odom_T_laser), *place.target_T_source), laser_T_base));
    message.keyframe = place.target.value;
    message.drive = static_cast<std::uint32_t>(record.drive);
    message.current_drive = static_cast<std::uint8_t>(record.drive == drive);
    message.keyframe_stamp = to_ros(record.stamp);
    message.keyframe_T_scan = to_message(place.target_T_source->pose);
    message.score = place.score;
    message.pairs = static_cast<std::uint32_t>(place.pairs);
    message.rms_residual = place.rms_residual;
    messages.push_back(message);
  }
  return messages;
}

}  // namespace falko_slam
