// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// The surfaces that every scenario knows.
std::vector<Surface> built_in_surfaces();

/// What a scenario's fields `surfaces`, `scatter_seed` and `world` describe.
World read_world(const YamlFields& scenario, const WorldVariation& variation = {});

}  // namespace falko_slam
