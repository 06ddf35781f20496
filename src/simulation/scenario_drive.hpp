// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/simulation/scenario.hpp"

namespace falko_slam {

/// The steps of a scenario's field `drive`, what is repeated written out; none that the actuators
/// cannot do.
std::vector<DriveStep> read_drive(const YamlFields& scenario, const ActuatorModel& actuators);

}  // namespace falko_slam
