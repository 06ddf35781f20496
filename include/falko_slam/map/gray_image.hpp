// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "falko_slam/map/grid_map.hpp"

namespace falko_slam {

/// An image of 8-bit gray values, row by row from the top.
struct GrayImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> pixels;
};

/// What map_saver draws: occupied cells black (0), free ones white (254), all others gray (205).
/// The upper image row is the last one of the map.
GrayImage trinary_image(const GridMap& map, const MapThresholds& thresholds = {});

/// What map_server calls raw: the cells' values, 255 for unknown.
GrayImage raw_image(const GridMap& map);

}  // namespace falko_slam
