// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

/// When two neighbouring beams have hit the same surface: if their points are nearer than max_step,
/// or than step_ratio times what perpendicular incidence at the nearer range would give.
struct SurfaceStepParams {
  double max_step = 0.15;   ///< [0, 100] [m]
  double step_ratio = 6.0;  ///< [0, 1000]
};
/// Throws std::invalid_argument with the field and its value.
inline void validate(const SurfaceStepParams& params) {
  require_in_range("max_step", params.max_step, 0.0, 100.0);
  require_in_range("step_ratio", params.step_ratio, 0.0, 1000.0);
}

/// `step`: between the points of the two beams; `range`: the nearer one's [m]; `angle`: between the
/// beams [rad].
inline bool on_one_surface(double step, double range, double angle,
                           const SurfaceStepParams& params) {
  return step < std::max(params.max_step, params.step_ratio * range * angle);
}

}  // namespace falko_slam
