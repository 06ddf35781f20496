// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/simulation_node_params.hpp"

#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {

const EnumNames<DriveSource>& drive_source_names() {
  static const EnumNames<DriveSource> names = {{"commands", DriveSource::kCommands},
                                               {"scenario", DriveSource::kScenario},
                                               {"bag", DriveSource::kBag}};
  return names;
}

void validate(const SimulationNodeParams& params) {
  if (params.scenario.empty()) {
    throw std::invalid_argument("scenario: must name a scenario file");
  }
  if (params.drive == DriveSource::kBag && params.drive_bag.empty()) {
    throw std::invalid_argument("drive_bag: must name a bag where drive is bag");
  }
  require_in_range("rate", params.rate, 0.01, 1000.0);
  require_in_range("seed", params.seed, 0, 2147483647);
  for (const std::string* frame :
       {&params.frames.world, &params.frames.odom, &params.frames.base, &params.frames.laser}) {
    if (frame->empty()) throw std::invalid_argument("frames must have names");
  }
}

SimulationNodeParams read_simulation_node_params(const XmlRpc::XmlRpcValue& tree,
                                                 const std::string& name,
                                                 std::vector<std::string>& unknown) {
  ParameterReader reader(tree, name);
  SimulationNodeParams params;
  visit_simulation_node_fields(params, reader);
  try {
    validate(params);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + "/" + error.what());
  }
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  return params;
}

}  // namespace falko_slam
