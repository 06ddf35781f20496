// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// A thing of a scenario's world.
struct Thing {
  Shape shape;                ///< of one copy, in its own frame
  std::vector<Pose2> copies;  ///< in the frame of the world or of what moves
  bool is_fixed = true;
  Body body;  ///< else when and where it is; its shape still empty
};

/// Reads the things of a list one after the other.
class ThingReader {
 public:
  /// `surfaces` must outlive it.
  ThingReader(const std::vector<Surface>& surfaces, const WorldVariation& variation)
      : surfaces_(surfaces), variation_(variation) {}

  Thing read(const YamlValue& value);

  std::uint64_t seed = 1;  ///< of the scattering

 private:
  std::size_t surface_of(const YamlFields& thing, const std::string& usual) const;

  const std::vector<Surface>& surfaces_;
  WorldVariation variation_;
  std::uint64_t number_ = 0;  ///< of the next thing
};

}  // namespace falko_slam
