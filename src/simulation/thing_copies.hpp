// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// A number that is normally distributed, at most three standard deviations of 1 from 0: always the
/// same one for the same three. Worlds are the same with every standard library, and taking one
/// copy of a thing away moves no other. scripts/plot_scenario counts alike.
double scattered(std::uint64_t seed, std::uint64_t thing, std::uint64_t draw);

/// Where the copies of a thing of the world are that stands at `world_T_thing`: as its fields
/// `repeat`, `without` and `scatter`, times a factor, say. `number` is that of the thing in the
/// list.
std::vector<Pose2> read_copies(const YamlFields& thing, const Pose2& world_T_thing,
                               double scatter_factor, std::uint64_t seed, std::uint64_t number);

}  // namespace falko_slam
