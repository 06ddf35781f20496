// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/GlobalLocalization.h>
#include <falko_slam/KeyframeArray.h>
#include <falko_slam/LoopConstraintArray.h>

#include <string>
#include <vector>

#include "falko_slam/place_recognition/keyframe_memory.hpp"

namespace falko_slam {

/// The keyframes from `first` on; `reset` if it is the very first one.
KeyframeArray to_message(const KeyframeMemory& memory, KeyframeId first,
                         const std::string& odom_frame);

/// The candidates of a keyframe that were matched.
LoopConstraintArray to_message(const KeyframeMemory& memory, KeyframeId source,
                               const LoopDetection& detection, const std::string& odom_frame);

/// What locate() found for a scan of a laser mounted so; `drive` is the one that is going on.
std::vector<PlaceHypothesis> to_messages(const KeyframeMemory& memory,
                                         const std::vector<LoopCandidate>& places,
                                         const Pose2& base_T_laser, std::size_t drive);

}  // namespace falko_slam
