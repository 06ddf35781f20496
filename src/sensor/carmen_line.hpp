// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "falko_slam/sensor/carmen_log.hpp"

namespace falko_slam {

/// The parsers of single lines, without their first word. Empty if the line is cut short, holds no
/// number where one belongs, or a number that no log can hold.
std::optional<CarmenScan> parse_flaser(const char* text, double range_max);
std::optional<CarmenScan> parse_robotlaser(const char* text);
std::optional<CarmenOdometry> parse_odom(const char* text);
std::optional<CarmenVertex> parse_vertex(const char* text);
/// The value of "name value ..." if the name is the one asked for.
std::optional<double> parse_param(const char* text, const std::string& name);

}  // namespace falko_slam
