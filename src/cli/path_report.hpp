// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_localization.hpp"

namespace falko_slam {
namespace cli {

/// Runs the named paths of a scenario's drive with every method and prints how far each is off at
/// the operation points (\cite kallasi2017 5.6, Figs. 5.10 to 5.14).
void evaluate_simulated_paths(const SimulatedLocalizationOptions& options,
                              const Scenario& scenario);

}  // namespace cli
}  // namespace falko_slam
