// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/mode_switch_params.hpp"

#include <stdexcept>

#include "falko_slam/common/file_below.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {

const EnumNames<VehicleMode>& vehicle_mode_names() {
  static const EnumNames<VehicleMode> names = {{"mapping", VehicleMode::kMapping},
                                               {"localization", VehicleMode::kLocalization}};
  return names;
}

void validate(const ModeSwitchParams& params) {
  for (const std::string* node :
       {&params.manager, &params.mapping_node, &params.localization_node}) {
    if (node->empty()) throw std::invalid_argument("nodes must have names");
  }
  if (params.mapping_node == params.localization_node) {
    throw std::invalid_argument("mapping_node and localization_node are both " +
                                params.mapping_node);
  }
  file_below("/", params.save_as);
  if (params.autosave_period != 0.0) {
    require_in_range("autosave_period", params.autosave_period, 1.0, 1e6);
  }
  require_in_range("check_period", params.check_period, 0.1, 60.0);
  require_in_range("refusal_shown_for", params.refusal_shown_for, 0.0, 1e6);
}

ModeSwitchParams read_mode_switch_params(const XmlRpc::XmlRpcValue& tree, const std::string& name,
                                         std::vector<std::string>& unknown) {
  ParameterReader reader(tree, name);
  ModeSwitchParams params;
  visit_mode_switch_fields(params, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period", kBeganWith});
  try {
    validate(params);
  } catch (const std::exception& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  return params;
}

}  // namespace falko_slam
