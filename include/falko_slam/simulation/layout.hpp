// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "falko_slam/simulation/scenario.hpp"

namespace falko_slam {

using LayoutStep = std::variant<WaitStep, FollowStep>;

/// The paths of a plant, in the frame of its map: lines with rounded corners, one after the other.
/// A path that has a name ends at an operation point.
struct Layout {
  std::string name;
  std::vector<LayoutStep> steps;
};

/// Reads the steps `wait`, `follow` and `repeat` of a scenario's `drive` (doc/scenarios.md), from a
/// file of their own or from a scenario. Throws std::runtime_error, "file: line 12: drive[3]: what
/// is wrong".
Layout read_layout(const std::string& path);

}  // namespace falko_slam
