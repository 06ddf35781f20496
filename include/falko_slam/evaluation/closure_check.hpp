// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "falko_slam/evaluation/error_summary.hpp"
#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// The closures of a SLAM run beside the poses that its graph ended with.
struct ClosureCheck {
  std::size_t accepted = 0;
  std::size_t refused = 0;
  /// Accepted ones that are off the poses by 0.5 m or 10 degrees and more, as the thesis calls a
  /// localization wrong (Section 4.2.1): false, where the poses are right.
  std::size_t far_off = 0;
  PoseErrors errors;  ///< of the accepted ones
};

/// Reads a table `closures.csv` of `falko slam`, whose columns are found by their names. Throws
/// std::runtime_error that names the file and the line; also for a keyframe that is not in the
/// graph.
ClosureCheck check_closures(const std::string& closures_csv, const PoseGraph& graph);

}  // namespace falko_slam
