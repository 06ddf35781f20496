// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

#include "falko_slam/geometry/angles.hpp"
#include "support/scene.hpp"

namespace falko_slam {
namespace test {

/// A scenario file: once around the office of office_scene(), with a scanner of so many beams.
inline std::string office_scenario(std::size_t beams) {
  std::ostringstream yaml;
  yaml.precision(12);
  const auto points = [&](double a, double b, double c, double d) {
    yaml << "[[" << a << ", " << b << "], [" << c << ", " << d << "]]";
  };
  yaml << "name: office\nstart: [-8.5, -1, 0]\nworld:\n";
  for (const Wall& wall : office_scene().walls) {
    yaml << "- wall: ";
    points(wall.from.x(), wall.from.y(), wall.to.x(), wall.to.y());
    yaml << "\n";
  }
  yaml << "laser:\n  beams: " << beams
       << "\n  angle_increment: " << kTwoPi / static_cast<double>(beams)
       << "\n  time_increment: " << 0.125 / static_cast<double>(beams) << "\n"
       << "drive:\n- follow: {through: [[9.3, -1], [9.3, 1], [-9.3, 1], [-9.3, -1], [-7, -1]], "
       << "speed: 0.8, corner_radius: 1}\n";
  return yaml.str();
}

}  // namespace test
}  // namespace falko_slam
