// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/common/yaml_value.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

// Values that scenarios are written with. What is something else throws as YamlValue does.

/// [x, y]
Eigen::Vector2d read_point(const YamlValue& value);

/// At least so many points, none of them where the one before is.
std::vector<Eigen::Vector2d> read_points(const YamlValue& value, std::size_t least);

/// [x, y, heading], or [x, y] where the heading is 0.
Pose2 read_pose(const YamlValue& value);

/// At least one.
std::vector<Pose2> read_poses(const YamlValue& value);

/// [length, width], along x and y.
Eigen::Vector2d read_size(const YamlValue& value);

double read_radius(const YamlValue& value);
double read_speed(const YamlValue& value);  ///< of a wheel or of what moves, without sign [m/s]

}  // namespace falko_slam
