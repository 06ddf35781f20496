// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "falko_slam/localization/landmark_map.hpp"

namespace falko_slam {

/// By its ending: a layout of reflectors as in imk_file.hpp. Anything else is YAML.
bool is_imk(const std::string& path);

/// Of either format; throws as read_imk() and read_landmark_map() do.
LandmarkMap read_map_of_any_format(const std::string& path);

/// In the format of the ending. Returns how many features it cannot hold, which are left out;
/// throws as write_imk() and write_landmark_map() do.
std::size_t write_map_of_any_format(const std::string& path, const LandmarkMap& map);

}  // namespace falko_slam
