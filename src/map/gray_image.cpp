// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/gray_image.hpp"

#include <algorithm>

namespace falko_slam {
namespace {

template <class GrayOf>
GrayImage draw(const GridMap& map, GrayOf gray_of) {
  validate(map);
  GrayImage image{map.width, map.height, {}};
  image.pixels.reserve(map.cells.size());
  for (std::size_t row = map.height; row-- > 0;) {
    for (std::size_t column = 0; column < map.width; ++column) {
      image.pixels.push_back(gray_of(map.at(column, row)));
    }
  }
  return image;
}

}  // namespace

GrayImage trinary_image(const GridMap& map, const MapThresholds& thresholds) {
  validate(thresholds);
  return draw(map, [&](std::int8_t cell) -> std::uint8_t {
    const std::int8_t stated = trinary_cell(cell, thresholds);
    if (stated < 0) return 205;
    return stated == 0 ? 254 : 0;
  });
}

GrayImage raw_image(const GridMap& map) {
  return draw(map, [](std::int8_t cell) { return static_cast<std::uint8_t>(cell); });
}

}  // namespace falko_slam
