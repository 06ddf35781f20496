// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

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

/// The tables as text on standard output; rotations in degrees.
void print_report(const std::vector<SlamResult>& results);

/// All figures; rotations in degrees.
nlohmann::json as_json(const std::vector<SlamResult>& results);

}  // namespace cli
}  // namespace falko_slam
