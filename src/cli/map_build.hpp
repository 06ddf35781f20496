// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "falko_slam/features/falko.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/localization/feature_mapper.hpp"

namespace falko_slam {
namespace cli {

struct MapBuildOptions {
  std::string bag;
  std::string topic;  ///< of the scans; empty: the only one
  std::string base_frame = "base_link";
  std::string reflectors;  ///< map to begin with; empty: none
  std::string poses;       ///< TUM file of base_link in the map, or a PoseStamped topic of the bag
  std::string out;
  std::string json;
  std::optional<Pose2> base_T_laser;  ///< empty: as the bag's tf has it
  double max_range = 15.0;            ///< of keypoints [m]
  FalkoParams falko;
  FeatureMapperParams mapper;
};

/// Maps the corners of a drive and says what became of them. Throws std::runtime_error.
void build_map(const MapBuildOptions& options);

}  // namespace cli
}  // namespace falko_slam
