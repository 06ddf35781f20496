// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_noise.hpp"

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

void validate(const CalibrationNoise& noise) {
  require_in_range("slip", noise.slip, 0.0, 0.1);
  require_in_range("steer", noise.steer, 0.0, 0.1);
  require_in_range("common_slip", noise.common_slip, 0.0, 0.1);
  require_in_range("common_steer", noise.common_steer, 0.0, 0.1);
  require_in_range("common_position", noise.common_position, 0.0, 1.0);
  require_in_range("common_turn", noise.common_turn, 0.0, 1.0);
  require_in_range("unknown_factor", noise.unknown_factor, 1.0, 16.0);
}

}  // namespace falko_slam
