// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/simulation/scenario.hpp"

namespace falko_slam {

/// Reads a scenario (doc/scenarios.md). Throws std::runtime_error, "file: line 12:
/// world[3].box.size: what is wrong", for everything that cannot be understood, keys that nobody
/// knows included.
Scenario read_scenario(const std::string& path);

}  // namespace falko_slam
