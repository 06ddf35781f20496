// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

/// Hands over the scans of a recording in its order: of a ROS bag (ending in .bag, .bag.gz or
/// .bag.bz2) the LaserScan messages of `topic`, of any other file those of a CARMEN log. The scan
/// is valid during the call only. Returns a line about what was read.
///
/// An empty topic means the only one of type LaserScan. Throws std::runtime_error that names the
/// file, and the topics in the bag if the one asked for is not there or not the only one.
std::string read_scans(const std::string& path, const std::string& topic,
                       const std::function<void(const RawScan&)>& use);

}  // namespace falko_slam
