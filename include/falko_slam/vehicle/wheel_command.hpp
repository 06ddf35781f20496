// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace falko_slam {

/// What a controller asks of a tricycle's driven and steered wheel.
struct WheelCommand {
  double wheel_speed = 0.0;  ///< as the nominal driving scale has it; negative: backwards [m/s]
  double steering = 0.0;     ///< as the steering encoder measures it [rad]
};

}  // namespace falko_slam
