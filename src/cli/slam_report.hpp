// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/closure_check.hpp"
#include "falko_slam/evaluation/relations.hpp"
#include "falko_slam/evaluation/trajectory_error.hpp"

namespace falko_slam {
namespace cli {

/// What was measured of one trajectory.
struct SlamResult {
  std::string trajectory;  ///< the file's name
  std::size_t poses = 0;
  std::optional<RelationErrors> relations;
  std::optional<TrajectoryErrors> truth;
};

/// What was measured of a folder that falko slam wrote; `closures` where it holds any.
struct SlamEvaluation {
  std::vector<SlamResult> trajectories;
  std::optional<ClosureCheck> closures;
};

/// The tables as text on standard output; rotations in degrees.
void print_report(const SlamEvaluation& evaluation);

/// All figures; rotations in degrees.
nlohmann::json as_json(const SlamEvaluation& evaluation);

}  // namespace cli
}  // namespace falko_slam
