// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "falko_slam/simulation/scenario.hpp"

namespace falko_slam {

/// The same world otherwise: what a scenario's things would be if they stood less neatly.
struct WorldVariation {
  double scatter = 1.0;                            ///< times `scatter` of all things. [0, 100]
  double bulge = 1.0;                              ///< times `bulge` of all things. [0, 100]
  std::optional<std::uint64_t> scatter_seed = {};  ///< in place of the scenario's own
};
/// Throws std::invalid_argument with the field and its value.
void validate(const WorldVariation& variation);

/// Reads a scenario (doc/scenarios.md). Throws std::runtime_error, "file: line 12:
/// world[3].box.size: what is wrong", for everything that cannot be understood, keys that nobody
/// knows included.
Scenario read_scenario(const std::string& path, const WorldVariation& variation = {});

}  // namespace falko_slam
