// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

// PLACEHOLDER: the real one comes from elsewhere.

/// Writes beside the file and renames. Throws std::runtime_error that names the file.
void save_slam_state(const std::string& path, const SlamState& state);

/// Throws std::runtime_error that names the file and what is wrong with it.
SlamState load_slam_state(const std::string& path);

}  // namespace falko_slam
