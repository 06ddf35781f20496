// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_params.hpp"

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

void validate(const SlamGraphParams& params) {
  require_in_range("neighbors", params.neighbors, 0, 100);
  require_in_range("step_distance", params.step_distance, 1e-4, 10.0);
  require_in_range("step_turn", params.step_turn, 1e-4, 10.0);
  require_in_range("urgent_distance", params.urgent_distance, 0.0, 100.0);
  require_in_range("urgent_turn", params.urgent_turn, 0.0, kPi);
  require_in_range("optimize_every", params.optimize_every, 1, 1000000);
  require_in_range("anchor_distance", params.anchor_distance, 0.01, 100.0);
  require_in_range("anchor_turn", params.anchor_turn, 0.01, kPi);
}

void validate(const SlamParams& params) {
  validate(params.scan);
  validate(params.tracker);
  validate(params.link);
  validate(params.nearby);
  validate(params.loops);
  validate(params.graph);
  validate(params.consistency);
  validate(params.optimizer);
  validate(params.map);
}

}  // namespace falko_slam
