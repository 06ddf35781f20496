// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/localization/landmark_map.hpp"

namespace falko_slam {

/// By its ending: a layout of reflectors as in imk_file.hpp. Anything else is YAML.
bool is_imk(const std::string& path);

/// Of either format; throws as read_imk() and read_landmark_map() do.
LandmarkMap read_map_of_any_format(const std::string& path);

}  // namespace falko_slam
