// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/bytes.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// A pose in a binary file: x, y [m], theta [rad] as f64.
constexpr std::size_t kPoseBytes = 3 * sizeof(double);

void put(ByteWriter& out, const Pose2& pose);

/// Throws std::runtime_error for one that no vehicle ever had: beyond 1e9 m or a turn, or NaN.
Pose2 take_pose(ByteReader& in);

}  // namespace falko_slam
