// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_map.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "falko_slam/common/validation.hpp"
#include "landmark_fields.hpp"

namespace falko_slam {
namespace {

constexpr int kMostHits = 1000000000;
constexpr double kRounding = 1e-9;  // of a correlation

}  // namespace

bool is_covariance(const Eigen::Matrix2d& c) {
  if (!c.allFinite() || c(0, 0) < 0.0 || c(1, 1) < 0.0 || c(0, 1) != c(1, 0)) return false;
  return c(0, 1) * c(0, 1) <= c(0, 0) * c(1, 1) * (1.0 + kRounding);
}

void validate(const MapLandmark& landmark) {
  require_in_range("id", landmark.id, 0, kMostLandmarkId);
  require_in_range("position.x", landmark.position.x(), -kFarthestLandmark, kFarthestLandmark);
  require_in_range("position.y", landmark.position.y(), -kFarthestLandmark, kFarthestLandmark);
  if (!is_covariance(landmark.covariance)) {
    throw std::invalid_argument("covariance: must be symmetric and positive semidefinite");
  }
  require_in_range("hits", landmark.hits, 0, kMostHits);
  const ReflectorLayout& layout = landmark.layout;
  require_in_range("diameter", layout.diameter, 0.0, 65.535);
  require_in_range("type", layout.type, 0, 255);
  require_in_range("subtype", layout.subtype, 0, 65535);
  if (layout.layers.empty()) throw std::invalid_argument("layers: must have at least one");
  for (const int layer : layout.layers) require_in_range("layers", layer, 0, kMostLayer);
}

const MapLandmark* LandmarkMap::find(int id) const {
  const auto found = std::find_if(landmarks.begin(), landmarks.end(),
                                  [id](const MapLandmark& landmark) { return landmark.id == id; });
  return found == landmarks.end() ? nullptr : &*found;
}

void validate(const LandmarkMap& map) {
  std::unordered_map<int, std::size_t> place_of;
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    const std::string name = "landmarks[" + std::to_string(i) + "]";
    try {
      validate(map.landmarks[i]);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(name + "." + error.what());
    }
    const auto [first, is_new] = place_of.emplace(map.landmarks[i].id, i);
    if (is_new) continue;
    throw std::invalid_argument(name + ".id = " + std::to_string(map.landmarks[i].id) +
                                ": landmarks[" + std::to_string(first->second) +
                                "] has it already");
  }
}

}  // namespace falko_slam
