// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// The reflectors of a world as a survey would give them: each coordinate with an error of this
/// standard deviation [m], which the map's covariances state. Numbered from 1.
LandmarkMap surveyed_map(const World& world, double deviation, std::mt19937_64& random);

}  // namespace falko_slam
