// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/surveyed_map.hpp"

#include "falko_slam/simulation/laser_scanner.hpp"

namespace falko_slam {

LandmarkMap surveyed_map(const World& world, double deviation, std::mt19937_64& random) {
  std::normal_distribution<double> error;
  LandmarkMap map;
  for (const Cylinder& reflector : reflectors_of(world)) {
    MapLandmark landmark;
    landmark.id = static_cast<int>(map.landmarks.size()) + 1;
    landmark.position.x() = reflector.center.x() + deviation * error(random);
    landmark.position.y() = reflector.center.y() + deviation * error(random);
    landmark.covariance = deviation * deviation * Eigen::Matrix2d::Identity();
    landmark.layout.diameter = 2.0 * reflector.radius;
    map.landmarks.push_back(landmark);
  }
  return map;
}

}  // namespace falko_slam
