// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/map_format.hpp"

#include <algorithm>
#include <cctype>

#include "falko_slam/localization/imk_file.hpp"

namespace falko_slam {

bool is_imk(const std::string& path) {
  const std::string ending = ".imk";
  if (path.size() <= ending.size()) return false;
  return std::equal(ending.begin(), ending.end(), path.end() - 4, [](char wanted, char letter) {
    return wanted == std::tolower(static_cast<unsigned char>(letter));
  });
}

LandmarkMap read_map_of_any_format(const std::string& path) {
  return is_imk(path) ? read_imk(path) : read_landmark_map(path);
}

std::size_t write_map_of_any_format(const std::string& path, const LandmarkMap& map) {
  if (is_imk(path)) return write_imk(path, map);
  write_landmark_map(path, map);
  return 0;
}

}  // namespace falko_slam
