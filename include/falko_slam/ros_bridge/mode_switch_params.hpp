// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "falko_slam/common/enum_names.hpp"

namespace falko_slam {

/// What sends tf map -> odom on a vehicle.
enum class VehicleMode {
  kMapping,       ///< PoseGraph: a map is made
  kLocalization,  ///< Localizer: a map is used
};
const EnumNames<VehicleMode>& vehicle_mode_names();

/// Where the node remembers the state that mapping has begun with, among its parameters.
constexpr char kBeganWith[] = "began_with";

/// Parameters of the ModeSwitch node; what they mean stands in config/mode_switch.yaml.
struct ModeSwitchParams {
  std::string manager = "falko_slam_manager";
  VehicleMode mode = VehicleMode::kLocalization;
  std::string mapping_node = "pose_graph";
  std::string localization_node = "localizer";
  std::string save_as = "agv";
  double autosave_period = 60.0;    ///< [s], 0 or [1, 1e6]
  double check_period = 1.0;        ///< [s], [0.1, 60]
  double refusal_shown_for = 60.0;  ///< [s], [0, 1e6]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ModeSwitchParams& params);

template <class Params, class Visitor>
void visit_mode_switch_fields(Params& params, Visitor& visitor) {
  visitor.field("manager", params.manager);
  visitor.choice("mode", params.mode, vehicle_mode_names());
  visitor.field("mapping_node", params.mapping_node);
  visitor.field("localization_node", params.localization_node);
  visitor.field("save_as", params.save_as);
  visitor.field("autosave_period", params.autosave_period);
  visitor.field("check_period", params.check_period);
  visitor.field("refusal_shown_for", params.refusal_shown_for);
}

/// `name` stands before the names in messages; `unknown` gets the names that no field has. Throws
/// std::invalid_argument with the parameter's full name.
ModeSwitchParams read_mode_switch_params(const XmlRpc::XmlRpcValue& tree, const std::string& name,
                                         std::vector<std::string>& unknown);

}  // namespace falko_slam
